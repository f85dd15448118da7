"""Ten wrong derivations of the kind that models write, and their right twins, each asked through the server. Usage: client.py PROGRAM"""

import asyncio
import sys
from pathlib import Path

from mcp import ClientSession, StdioServerParameters
from mcp.client.stdio import stdio_client

ROOT = Path(__file__).resolve().parents[2]

# What is asked, with what is given, which symbols, and the verdict.
STEPS = [
    (r"\sqrt{x^2}=x", [], ["x"], "refuted_by_a_point"),
    (r"\sqrt{x^2}=x", ["x>0"], ["x"], "proved"),
    (r"\ln(xy)=\ln x+\ln y", ["x<0", "y<0"], ["x, y"], None),
    (r"\ln(xy)=\ln x+\ln y", ["x>0", "y>0"], ["x, y"], "proved"),
    (r"(a+b)^2=a^2+b^2", [], ["a, b"], "refuted_by_a_point"),
    (r"(a+b)^2=a^2+2ab+b^2", [], ["a, b"], "proved"),
    (r"\frac{x^2-1}{x-1}=x+1", [], ["x"], "proved"),
    (r"\arcsin(\sin x)=x", [], ["x"], "refuted_by_a_point"),
    (r"x=2", ["x^2=4"], ["x"], "refuted_by_a_point"),
    (r"x=2", ["x^2=4", "x>0"], ["x"], "proved"),
    (r"\cos 2x=1-\sin^2x", [], ["x"], "refuted_by_a_point"),
    (r"\cos 2x=1-2\sin^2x", [], ["x"], "proved"),
    (r"\frac{d}{dt}\dot q^2=\dot q\ddot q", [], ["q: state"], "refuted_by_a_point"),
    (r"\frac{d}{dt}\dot q^2=2\dot q\ddot q", [], ["q: state"], "proved"),
    (r"AB=BA", [], ["A, B: 2x2"], "refuted_by_a_point"),
    (r"\frac12\dot q^2+\frac12q^2=C", [r"\ddot q=-q"], ["q: state", "C"], "refuted_by_a_point"),
    (r"\ddot q=-q", [r"\frac12\dot q^2+\frac12q^2=C"], ["q: state", "C"], None),
]


async def ask(session, tool, **arguments):
    answer = await session.call_tool(tool, arguments)
    if answer.isError:
        return answer.content[0].text
    return answer.structuredContent


async def main(program):
    parameters = StdioServerParameters(command=program, args=["mcp", "--folder", str(ROOT), "--deadline", "120"])
    async with stdio_client(parameters) as streams, ClientSession(*streams) as session:
        began = await session.initialize()
        assert began.serverInfo.name == "rederive"
        names = [tool.name for tool in (await session.list_tools()).tools]
        assert names == ["prove", "lint", "check", "explain", "search", "read_formula", "units"], names

        for formula, given, symbols, wanted in STEPS:
            found = await ask(session, "prove", formula=formula, given=given, symbols=symbols)
            assert isinstance(found, dict), f"{formula}: {found}"
            print(f"{found['verdict']:20} {formula}  given {given}")
            assert wanted is None or found["verdict"] == wanted, found
            assert wanted is not None or found["verdict"] != "proved", found
            if found["verdict"] == "refuted_by_a_point":
                assert found["witness"], found

        chain = r"\begin{align} K &= \tfrac12 m(\dot x^2+\dot y^2) \\ &= \tfrac12 m\dot x^2 - \tfrac12 m\dot y^2 \end{align}"
        found = await ask(session, "lint", text=chain)
        assert found["words"]["wrong"] == 1, found
        [wrong] = [r for r in found["relations"] if r["verdict"] == "wrong_refuted_by_a_point"]
        assert wrong["instead"] and wrong["line"] == 1, wrong
        found = await ask(session, "lint", path="tests/lint/page.tex")
        assert found["words"]["wrong"] == 2, found

        found = await ask(session, "check", path="derivations/rabi.toml")
        assert found["as_expected"] and any(v["verdict"] == "holds_proved" for v in found["verdicts"]), found
        found = await ask(session, "units", path="derivations/pendulum.toml")
        assert found["verdict"] in ("units_agree_where_they_are_known", "no_units_are_known"), found
        found = await ask(session, "read_formula", formula=r"\frac12mv^2", symbols=["m, v"])
        assert found["verdict"] == "read", found
        found = await ask(session, "read_formula", formula=r"\sin\omega(t-t_0)", symbols=["\\omega, t, t_0"])
        assert found["verdict"] == "not_read", found
        explained = await ask(session, "explain", path="derivations/rabi.toml", claim="none")
        assert isinstance(explained, str) and "none" in explained, explained

        # What lies beyond the folder is not read; arguments that a tool does not take are told.
        for path in ["../etc/passwd", "/etc/passwd", "derivations/../../etc/passwd", "no-such-file.toml"]:
            found = await ask(session, "check", path=path)
            assert isinstance(found, str) and "folder" in found, found
        assert "takes no" in await ask(session, "prove", formula="1=1", shell="ls")
        assert "needs" in await ask(session, "prove")
        assert isinstance(await ask(session, "prove", formula="{" * 100_000), str)
        assert (await ask(session, "prove", formula="1+1=2"))["verdict"] == "proved"
    print("the server ends with its client")


asyncio.run(main(sys.argv[1]))
