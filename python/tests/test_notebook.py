"""The tutorial, executed, and what its cells show."""

import json
import os
from pathlib import Path
from typing import Any

import pytest

import rederive
from rederive import notebook

nbformat = pytest.importorskip("nbformat")
nbclient = pytest.importorskip("nbclient")
BOOKS = Path(__file__).resolve().parents[1]


def run(book: Any) -> list[Any]:
    nbclient.NotebookClient(book, timeout=300, kernel_name="python3").execute()
    return [cell for cell in book.cells if cell.cell_type == "code"]


def test_the_tutorial_runs_and_shows_what_it_says() -> None:
    cells = run(nbformat.read(BOOKS / "tutorial.ipynb", as_version=4))

    def shown(cell: Any, kind: str) -> str:
        found = [o["data"][kind] for o in cell.outputs if o.output_type in ("execute_result", "display_data") and kind in o["data"]]
        return "".join(found) + "".join(o["text"] for o in cell.outputs if o.output_type == "stream" and kind == "text/plain")

    text = "\n".join(shown(cell, "text/plain") for cell in cells)
    pages = [shown(cell, "text/html") for cell in cells if shown(cell, "text/html")]
    assert "refuted" in text and "Decision.PROVED" in text and "neither true nor false" in text
    rows = [line for line in text.splitlines() if "simplify:" in line]
    assert len(rows) == 7 and all(" proved" in row for row in rows), rows
    assert "harmonic on wide: fails" in text and "['holds', 'holds']" in text
    assert "Summary(holds=1, fails=0" in text
    # A proof, the report with the curves of what fails, the report of a cell, the page of LaTeX, a list, a table.
    assert "this step is wrong" in pages[3] and "<math" in pages[3] and pages[4].count("<tr>") == 4 and "proved" in pages[5]
    pages = pages[:5]
    assert len(pages) == 5 and all(page.startswith("<style>") and "http" not in page for page in pages)
    assert pages[1].count("<svg") == 2 and '<span class="fails wrong">F</span>' in pages[1]
    # For a browser: see `python/test`.
    if place := os.environ.get("REDERIVE_CELLS"):
        Path(place).write_text(json.dumps(pages), encoding="utf-8")
    assert any("image/png" in o.get("data", {}) for cell in cells for o in cell.outputs)


def kinds(cells: list[Any]) -> list[list[str]]:
    """Of each cell the kinds of what it shows."""
    return [sorted({kind for o in cell.outputs for kind in o.get("data", {"stream": ""})}) for cell in cells]


def test_what_cells_show_is_stored() -> None:
    for name in ("tutorial.ipynb", "identities.ipynb"):
        stored = nbformat.read(BOOKS / name, as_version=4)
        shown = kinds([cell for cell in stored.cells if cell.cell_type == "code"])
        assert shown == kinds(run(stored)) and any(shown), f"{name}: run python/notebooks"


def test_the_seven_identities_of_the_bench() -> None:
    cells = run(nbformat.read(BOOKS / "identities.ipynb", as_version=4))
    text = "".join(o["text"] for cell in cells for o in cell.outputs if o.output_type == "stream")
    rows = [line for line in text.splitlines() if "simplify:" in line and not line.startswith("all")]
    assert len(rows) == 7 and all(" proved " in row for row in rows), rows
    assert text.splitlines()[-1].startswith("refuted Counterexample")


def test_a_wrong_first_line_of_a_cell(spring: str) -> None:
    space: dict[str, Any] = {}
    for line, words in [("--claims energy", "usage: %%rederive"), ("my-report", "no name in Python"), ("a --claim none", "`none`")]:
        with pytest.raises(rederive.Error) as e:
            notebook.run(line, spring, space)
        assert words in str(e.value) and not space
    assert notebook.run("a --claim energy --trajectory pulled --sampled", spring, space) is space["a"]


def test_problems_of_a_cell_are_shown_without_a_trace() -> None:
    book = nbformat.v4.new_notebook()
    book.cells = [
        nbformat.v4.new_code_cell("%load_ext rederive"),
        nbformat.v4.new_code_cell("%%rederive\n[derivation]\ntitle = 'x'"),
    ]
    with pytest.raises(nbclient.exceptions.CellExecutionError) as e:
        run(book)
    assert "derivation::missing-key" in str(e.value) and "report.toml:1:1" in str(e.value)
    assert 'File "' not in str(e.value)
