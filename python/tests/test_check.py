"""Checks: values, names, documents, curves, copies."""

import json
import multiprocessing
import pickle
from pathlib import Path

import pytest

import rederive
from rederive import Strength, Verdict


@pytest.fixture(scope="module")
def report(spring: str) -> rederive.Report:
    return rederive.check(text=spring)


def test_verdicts_are_found(report: rederive.Report) -> None:
    assert report.title == "A spring"
    energy = report["energy", "pulled"]
    assert energy.verdict is Verdict.HOLDS and energy.strength in (Strength.ENCLOSED, Strength.PROVED)
    assert not energy.unexpected and energy.expected is None
    assert report["rest/at-once", "pulled"].verdict is Verdict.FAILS
    assert report["rest/at-once", "pulled"].expected is Verdict.FAILS
    begin = report["rest/begin"]
    assert [r.verdict for r in begin] == [Verdict.HOLDS, Verdict.FAILS]
    assert [r.trajectory for r in report.unexpected] == ["pushed"] and report.summary.unexpected == 1
    witness = report["rest/begin", "pushed"].witness
    assert witness is not None and witness.left == 1.0 and witness.right == 0.0
    assert "rest/begin on pushed: fails" in str(report) and "left   1" in str(report)
    assert "1 not as expected" in repr(report)


def test_names_that_are_not_there(report: rederive.Report, spring: str) -> None:
    for name in ("nothing", "rest", ("energy", "nowhere")):
        with pytest.raises(rederive.UnknownName) as e:
            report[name]
        assert isinstance(e.value, KeyError)
    with pytest.raises(rederive.UnknownName, match="rest/begin"):
        report["rest"]
    with pytest.raises(rederive.UnknownName, match="nowhere"):
        rederive.check(text=spring, trajectories="nowhere")
    with pytest.raises(ValueError, match="sampled"):
        rederive.check(text=spring, rigor="certain")  # type: ignore[arg-type]


def test_a_part_can_be_asked_for(spring: str) -> None:
    part = rederive.check(text=spring, claims=["rest/begin"], trajectories="pushed", rigor="sampled")
    assert [(r.claim, r.trajectory) for r in part.results] == [("rest/begin", "pushed")]
    assert part["rest/begin", "pushed"].strength is Strength.SAMPLED


def test_nothing_has_a_truth_value(report: rederive.Report) -> None:
    for value in (report, report["energy"], report["energy", "pulled"], Verdict.HOLDS, Strength.PROVED):
        with pytest.raises(TypeError):
            bool(value)


def test_a_path_and_a_text_are_two_things(tmp_path: Path, spring: str, report: rederive.Report) -> None:
    path = tmp_path / "derivation"
    path.write_text(spring, encoding="utf-8")
    for given in (rederive.check(path), rederive.check(str(path)), rederive.check(path=path), rederive.check(path=str(path))):
        assert [r.verdict for r in given.results] == [r.verdict for r in report.results]
    with pytest.raises(FileNotFoundError):
        rederive.check("no/such/file.toml")
    # A text is not taken for a path, not even where it is the path of a file that is there; and no path for a text.
    with pytest.raises(rederive.DerivationError):
        rederive.check(text=str(path))
    for wrong in (rederive.check, rederive.Session, rederive.Session(path).change):
        with pytest.raises(TypeError, match="text="):
            wrong(spring)
    with pytest.raises(TypeError, match="is one of"):
        rederive.check(text=spring, path=path)
    with pytest.raises(TypeError, match="is one of"):
        rederive.check(path, text=spring)
    with pytest.raises(TypeError, match="not PosixPath|not WindowsPath"):
        rederive.check(text=path)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="nothing to check"):
        rederive.check()


def test_copies_are_equal(report: rederive.Report, spring: str) -> None:
    copy = pickle.loads(pickle.dumps(report))
    assert copy == report and hash(copy) == hash(report) and copy is not report
    assert copy.results == report.results and copy.curve("energy", "pulled").formula == report.curve("energy", "pulled").formula
    assert copy.page() == report.page()
    assert report != rederive.check(text=spring, rigor="sampled")
    again = pickle.loads(pickle.dumps(rederive.Session(text=spring)))
    assert again.claims == ("energy", "rest/at-once", "rest/begin")


def test_the_document_is_that_of_the_program(report: rederive.Report) -> None:
    data = json.loads(report.json())
    assert data == report.data and data["schema"] == 1
    assert report.markdown().startswith("# A spring")
    assert report.latex().startswith("\\documentclass") and "\\end{document}" in report.latex()
    assert "<!doctype html>" in report.page()[:100].lower()


def test_verdicts_are_explained(report: rederive.Report) -> None:
    told = report.explain("rest")
    assert "rest/at-once" in told and "rest/begin" in told and "\x1b" not in told
    one = report.explain("rest/begin")
    assert "rest/begin" in one and "rest/at-once" not in one
    with pytest.raises(rederive.UnknownName, match="no verdict on a claim `nothing`"):
        report.explain("nothing")


def test_curves_are_arrays(report: rederive.Report) -> None:
    numpy = pytest.importorskip("numpy")
    curve = report.curve("rest/at-once", "pushed")
    assert len(curve.t) > 20 and curve.t[0] == 0 and curve.t[-1] == 10
    assert numpy.allclose(curve.left, numpy.cos(0.7 * curve.t)) and numpy.all(curve.right == 0)
    assert numpy.all(curve.residual <= numpy.abs(curve.left - curve.right) + curve.bound)
    with pytest.raises(rederive.UnknownName):
        report.curve("energy", "nowhere")


def test_tables_and_pictures(report: rederive.Report) -> None:
    pandas = pytest.importorskip("pandas")
    frame = report.to_pandas()
    assert isinstance(frame, pandas.DataFrame) and len(frame) == 6
    assert list(frame[frame.unexpected].trajectory) == ["pushed"]
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    axes = report.plot("energy", "pulled")
    assert axes.get_xlabel() == "t" and axes.get_ylabel()
    assert [line.get_label() for line in axes.get_lines()] == ["left side", "right side"]


def test_html_is_one_piece_and_harmless(spring: str) -> None:
    text = spring.replace("A spring", "<script>alert(1)</script>")
    shown = rederive.check(text=text)._repr_html_()
    assert "<script" not in shown and "&lt;script" in shown
    # The picture has axes with numbers.
    assert shown.count("<text") >= 5 and ">10</text>" in shown
    assert "<svg" in shown and "prefers-color-scheme:dark" in shown and "not as expected" in shown
    assert "http:" not in shown and "https:" not in shown
    assert "fails" in rederive.check(text=spring)["rest/begin", "pushed"]._repr_html_()


def test_problems_have_places() -> None:
    text = "[derivation]\ntitle = 'Decay'\nconcerns = 'x'\n[symbols]\n't' = { role = 'tim' }\n"
    with pytest.raises(rederive.DerivationError) as e:
        rederive.Session(text=text, name="decay.toml")
    problem = e.value.problems[0]
    assert (problem.path, problem.line) == ("decay.toml", 5) and problem.column is not None
    assert "^" in problem.text and "decay.toml:5:" in str(e.value)
    copy = pickle.loads(pickle.dumps(e.value))
    assert copy.problems == e.value.problems


def test_what_holds_instead_is_offered(spring: str) -> None:
    text = spring.replace("['v=0']\nexpect = { fails = 'all' }", "['\\dot v=-2\\omega^2x']")
    claim = rederive.check(text=text, claims="rest/at-once")["rest/at-once"]
    first = claim.corrections[0]
    assert (first.formula, first.edits, first.holds_on) == (r"\dot v=-\omega^2x", ("factor",), 2)
    assert first.strength is rederive.Strength.PROVED and r"holds instead: \dot v=-\omega^2x, proved" in str(first)
    with pytest.raises(TypeError, match="neither true nor false"):
        bool(first)
    assert rederive.check(text=text, only_verdicts=True)["rest/at-once"].corrections == ()
    assert rederive.check(text=text)["energy"].corrections == ()


def test_a_session_takes_another_state(spring: str) -> None:
    session = rederive.Session(text=spring)
    assert ("rest/begin", "pushed") in session.pairs and len(session.pairs) == 6
    with pytest.raises(rederive.DerivationError):
        session.change(text="[derivation]\n")
    assert len(session.claims) == 3
    session.change(text=spring.replace("'v(0)=0'", "'v(0)<2'"))
    assert session.check(["rest/begin"]).summary.fails == 0
    assert session.prove("x^2=v", scope=None).verdict is rederive.Decision.REFUTED


def _unexpected(text: str) -> int:
    return rederive.check(text=text).summary.unexpected


@pytest.mark.skipif("fork" not in multiprocessing.get_all_start_methods(), reason="no fork on this system")
@pytest.mark.filterwarnings("ignore::DeprecationWarning")
def test_a_fork_computes_too(spring: str) -> None:
    assert _unexpected(spring) == 1
    with multiprocessing.get_context("fork").Pool(1) as pool:
        assert pool.apply_async(_unexpected, (spring,)).get(60) == 1


def test_progress_is_told(spring: str, derivations: Path) -> None:
    told: list[tuple[int, int]] = []
    rederive.check(derivations / "pendulum.toml", progress=lambda done, of: told.append((done, of)))
    assert told and all(0 <= done <= of for done, of in told) and told == sorted(told)

    class Stop(Exception):
        pass

    def stop(done: int, of: int) -> None:
        raise Stop

    with pytest.raises(Stop):
        rederive.check(derivations / "pendulum.toml", progress=stop)


def test_a_deadline_leaves_the_rest_open(derivations: Path) -> None:
    report = rederive.check(derivations / "pendulum.toml", deadline=0)
    assert report.summary.undecided > 0
    assert any("work limit" in (r.reason or "") for r in report.results)
