"""The table of the page for agents: every cell is what the program, or SymPy, answers. Usage: table.py PROGRAM"""

import asyncio
import re
import sys
from pathlib import Path

import sympy
from mcp import ClientSession, StdioServerParameters
from mcp.client.stdio import stdio_client

PAGE = Path(__file__).resolve().parents[2] / "docs/agents.md"
SYMBOLS = ["x, a, b, C", "q: state", "A, B: 2x2"]
t = sympy.Symbol("t")
# No assumption, as an agent declares them.
NAMES = {**vars(sympy), **{name: sympy.Symbol(name) for name in "xab"}, "t": t, "q": sympy.Function("q")(t)}
NAMES |= {name: sympy.MatrixSymbol(name, 2, 2) for name in "AB"}


def rows() -> list[list[str]]:
    _, table = PAGE.read_text(encoding="utf-8").split("## Steps that models write")
    lines = [line for line in table.splitlines() if line.startswith("| `")]
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in lines]


def code(cell: str) -> list[str]:
    return re.findall("`([^`]*)`", cell)


async def main(program: str) -> None:
    parameters = StdioServerParameters(command=program, args=["mcp"])
    async with stdio_client(parameters) as streams, ClientSession(*streams) as session:
        await session.initialize()
        count = 0
        for wrong, asked, gives, found, right, holds in rows():
            answer = str(eval(code(asked)[0], dict(NAMES)))
            assert [answer] == code(gives), f"{asked} gives {answer}"
            for cell, verdict in (wrong, found), (right, holds):
                formula, *given = code(cell)
                result = await session.call_tool("prove", {"formula": formula, "given": given, "symbols": SYMBOLS})
                assert not result.isError, (formula, result.content)
                said = result.structuredContent["verdict"]
                assert [said] == code(verdict), f"{formula}, given {given}: {said}"
            count += 1
        assert count == 10, count
        print(f"{count} rows of the table are as they are answered")


asyncio.run(main(sys.argv[1]))
