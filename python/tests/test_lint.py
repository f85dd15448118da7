"""Papers and cells of LaTeX, formula by formula; formulas as notebooks show them; answers on lists."""

import pickle
from pathlib import Path
from typing import Any

import pytest

import rederive
from rederive import Decision, notebook, progress

# More macros that do not end than are left out.
ENDLESS = "".join(f"\\def\\{c}{{\\{c}\\{c}}}\\{c} " for c in "abcdefghijklmnopqrstuvwxyz")
WRONG = "(a+b)^2 = a^2+b^2+3ab\n\\sin 2x = 2\\sin x\\cos x"


def test_a_paper_is_looked_through(derivations: Path) -> None:
    paper = derivations.parent / "tests" / "lint" / "page.tex"
    found = rederive.lint(paper)
    assert len(found.wrong) == 2 and found.words["wrong"] == 2 and len(found) == sum(found.words.values())
    first = found.wrong[0]
    assert first.line > 1 and first.instead and first.message and "its sides are" in first.message and first.file.endswith("page.tex")
    assert found == rederive.lint(str(paper)) == pickle.loads(pickle.dumps(found))
    assert "<!doctype html>" in found.page()[:100].lower() and repr(found).startswith("<Lint of")
    for value in (found, first):
        with pytest.raises(TypeError):
            bool(value)


def test_a_text_is_no_path(tmp_path: Path) -> None:
    file = tmp_path / "a.tex"
    file.write_text("\\[1+1=2\\]", encoding="utf-8")
    assert [one.verdict for one in rederive.lint(file)] == ["follows_proved"]
    assert all(one.verdict != "follows_proved" for one in rederive.lint(text=str(file)))
    with pytest.raises(FileNotFoundError):
        rederive.lint("\\[1+1=2\\]")
    with pytest.raises(TypeError, match="one of"):
        rederive.lint()
    with pytest.raises(TypeError, match="one of"):
        rederive.lint(file, text="1=1")
    with pytest.raises(rederive.DerivationError, match="does not end"):
        rederive.lint(text=ENDLESS)
    left_out = rederive.lint(text="\\def\\a{\\a\\a}\\[1+1=2\\] \\a")
    assert [one.verdict for one in left_out] == ["follows_proved"]


def test_formulas_without_marks_are_displays_on_their_lines() -> None:
    found = rederive.lint(text=WRONG)
    assert [(one.line, one.verdict) for one in found] == [(1, "wrong_refuted_by_a_point"), (2, "follows_proved")]
    chain = rederive.lint(text="x^2-y^2 &= (x-y)(x+y) \\\\\n &= x(x+y) - y(x+y)")
    assert [one.verdict for one in chain] == ["follows_proved"]


def test_what_is_found_is_shown_and_harmless() -> None:
    pandas = pytest.importorskip("pandas")
    found = rederive.lint(text=WRONG)
    shown = found._repr_html_()
    assert shown.count("<math") >= 4 and "a^2+b^2+2ab" in shown and "http" not in shown
    assert "holds, and is proved" in str(found) and found.wrong[0]._repr_latex_().startswith("$")
    frame = found.to_pandas()
    assert isinstance(frame, pandas.DataFrame) and list(frame.line) == [1, 2] and frame.instead[0] == "a^2+b^2+2ab"
    for bad in ("$a=<script>alert(1)</script>$", "$x_{<img src=x onerror=alert(1)>}=1$", "$a=\\text{<b>b</b>}$"):
        shown = rederive.lint(text=bad)._repr_html_()
        assert "<script" not in shown and "<img" not in shown and "<b>b" not in shown, shown
    assert "$" not in rederive.lint(text="\\[a=\\$b\\]").relations[0]._repr_latex_()[1:-1]


def test_a_proof_is_typeset() -> None:
    proof = rederive.prove(r"\sqrt{x^2}=x", "x")
    assert "<msqrt>" in proof._repr_html_() and proof._repr_latex_() == r"$\displaystyle \sqrt{x^2}=x$"
    assert pickle.loads(pickle.dumps(proof)).mathml == proof.mathml


def test_a_list_of_formulas(capsys: pytest.CaptureFixture[str]) -> None:
    pandas = pytest.importorskip("pandas")
    told: list[tuple[int, int]] = []
    found = rederive.prove([r"\sin 2x=2\sin x\cos x", r"\sqrt{x^2}=x"], "x", progress=lambda done, of: told.append((done, of)))
    assert [one.verdict for one in found] == [Decision.PROVED, Decision.REFUTED] and told == [(1, 2), (2, 2)]
    assert len(rederive.prove([])) == 0 and isinstance(found, rederive.Proofs)
    # A premise that can be read once only is given to each.
    given = (one for one in ["x>0"])
    assert [one.verdict for one in rederive.prove([r"\sqrt{x^2}=x", "|x|=x"], "x", given)] == [Decision.PROVED] * 2
    frame = found.to_pandas()
    assert isinstance(frame, pandas.DataFrame) and list(frame.verdict) == ["proved", "refuted"] and frame.left[1] == "3/2"
    shown = found._repr_html_()
    assert shown.count("<tr>") == 3 and "3/2 ≠ -3/2" in shown and repr(found).count("\n") == 1
    assert pickle.loads(pickle.dumps(found)) == found
    with pytest.raises(TypeError):
        bool(found)
    rederive.prove(["x=x"], "x", progress=True)
    assert "1/1 formulas" in capsys.readouterr().err


def test_expressions_of_sympy_are_asked_to_be_zero() -> None:
    sp = pytest.importorskip("sympy")
    t, x, y = sp.symbols("t x y", real=True)
    assert rederive.prove(sp.sin(2 * x) - 2 * sp.sin(x) * sp.cos(x)).verdict is Decision.PROVED
    assert rederive.prove(x - y).verdict is Decision.REFUTED
    # Beside texts, whose symbols are told.
    mixed = rederive.prove([r"\sin 2x=2\sin x\cos x", sp.sin(x) ** 2 + sp.cos(x) ** 2 - 1], "x")
    assert [one.verdict for one in mixed] == [Decision.PROVED] * 2
    assert rederive.prove(x - y, given=[sp.Eq(x, y)]).verdict is Decision.PROVED
    turn = sp.Matrix([[sp.cos(x), -sp.sin(x)], [sp.sin(x), sp.cos(x)]])
    assert rederive.prove(turn * turn.T - sp.diag(1, 1)).verdict is Decision.PROVED
    assert rederive.prove(turn * turn - sp.diag(1, 1)).verdict is Decision.REFUTED
    with pytest.raises(rederive.NoCounterpart, match="SymPy has made 0"):
        rederive.prove(x - x)
    with pytest.raises(TypeError, match="no motions"):
        rederive.check(x - y)
    q = sp.Function("q")(t)
    made = (
        rederive.Derivation("A spring")
        .symbol("t", "time")
        .symbol(q)
        .system("spring", q, sp.Eq(q.diff(t, 2), -q))
        .trajectory("one", system="spring", initial={q: 1, q.diff(t): 0}, span=[0, 3])
        .claim("equation", "It obeys", always=q.diff(t, 2) + q)
        .claim("other", "It does not obey", always=[q.diff(t, 2) - q])
    )
    report = rederive.check(made)
    assert [str(r.verdict) for r in report.results] == ["holds", "fails"]


def test_a_cell_of_latex() -> None:
    space: dict[str, Any] = {}
    assert isinstance(notebook.run("", WRONG, space), rederive.Lint) and len(space["found"].wrong) == 1
    notebook.run("mine --deadline 60", "$1+1=2$", space)
    assert [one.verdict for one in space["mine"]] == ["follows_proved"]
    with pytest.raises(rederive.Error, match="no claims"):
        notebook.run("--claim energy", WRONG, space)
    with pytest.raises(rederive.DerivationError):
        notebook.run("", ENDLESS, space)


def test_a_notebook_shows_the_bar_of_tqdm(monkeypatch: pytest.MonkeyPatch, derivations: Path) -> None:
    pytest.importorskip("tqdm")
    made: list[Any] = []

    class Bar:
        def __init__(self, **keys: Any) -> None:
            self.keys, self.n, self.total = keys, 0, None

        def __enter__(self) -> "Bar":
            made.append(self)
            return self

        def __exit__(self, *_: object) -> None:
            pass

        def update(self, by: int) -> None:
            self.n += by

    monkeypatch.setattr(progress, "in_notebook", lambda: True)
    monkeypatch.setattr(progress, "_bar", lambda: Bar)
    rederive.check(derivations / "pendulum.toml", cache=False)
    assert len(made) == 1 and made[0].n == made[0].total > 1 and made[0].keys["unit"] == " motions"
    assert made[0].keys["delay"] == progress.PATIENCE and made[0].keys["leave"] is False
