"""The front ends are thin: the table of the page counts their lines, and says the truth."""

import ast
import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
MOST = 200


def code_lines(path: Path) -> int:
    """Lines with code: no comments, no texts that only say something, no empty lines."""
    text = path.read_text(encoding="utf-8")
    lines = {at for at, line in enumerate(text.splitlines(), 1) if line.strip() and not line.strip().startswith(("//", "#"))}
    if path.suffix == ".rs":
        # An attribute begins as a comment of Python does.
        return len(lines | {at for at, line in enumerate(text.splitlines(), 1) if line.strip().startswith("#")})
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant) and isinstance(node.value.value, str):
            lines -= set(range(node.lineno, (node.end_lineno or node.lineno) + 1))
    return len(lines)


def test_the_table_of_front_ends() -> None:
    page = (ROOT / "docs/python.md").read_text(encoding="utf-8")
    rows = re.findall(r"\[`([^`]+)`\]\(\.\./\1\)[^|]*\| (\d+) \|", page)
    assert [path for path, _ in rows] == [
        "python/src/lib.rs",
        "python/src/papers.rs",
        "python/src/parts.rs",
        "python/package/rederive/__main__.py",
        "python/package/rederive/notebook.py",
        "python/package/rederive/pytest_plugin.py",
    ]
    for path, said in rows:
        counted = code_lines(ROOT / path)
        assert counted == int(said) <= MOST, (path, counted)
