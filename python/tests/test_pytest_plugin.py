"""The plugin, run by pytest in a folder of its own."""

import pytest


@pytest.fixture
def project(pytester: pytest.Pytester, spring: str) -> pytest.Pytester:
    pytester.makefile(".derivation.toml", spring=spring)
    folder = pytester.mkdir("papers")
    (folder / "decay.toml").write_text(spring.replace("'v(0)=0'", "'v(0)<2'"), encoding="utf-8")
    (folder / "notes.txt").write_text("no derivation", encoding="utf-8")
    pytester.makepyprojecttoml('[tool.pytest.ini_options]\nrederive_folders = ["papers"]\nrederive_rigor = "sampled"\n')
    return pytester


def test_a_test_for_each_claim_and_motion(project: pytest.Pytester) -> None:
    result = project.runpytest_subprocess("-p", "no:cacheprovider")
    # Two files of six pairs. What is expected to fail is as expected; one verdict is not.
    result.assert_outcomes(passed=11, failed=1)
    out = result.stdout.str()
    assert "rest/begin on pushed: fails (sampled), which nothing expects" in out
    assert "left   1" in out and "right  0" in out and "v(0)=0" in out
    assert "Traceback" not in out


def test_what_holds_instead_is_told(pytester: pytest.Pytester, spring: str) -> None:
    pytester.makefile(".derivation.toml", spring=spring.replace("['v=0']\nexpect = { fails = 'all' }", "['\\dot v=-2\\omega^2x']"))
    result = pytester.runpytest_subprocess("-p", "no:cacheprovider", "-k", "at-once and pulled")
    result.assert_outcomes(failed=1, deselected=5)
    assert r"holds instead: \dot v=-\omega^2x, proved, holds on 2 trajectories (factor)" in result.stdout.str()


def test_tests_are_selected_by_name(project: pytest.Pytester) -> None:
    result = project.runpytest_subprocess("-v", "-k", "energy and pulled")
    result.assert_outcomes(passed=2, deselected=10)
    result.stdout.fnmatch_lines(["*energy*pulled*PASSED*"])


def test_families_are_tests(pytester: pytest.Pytester, spring: str) -> None:
    row = "[[family]]\nid = 'row'\nof = 'pulled'\nvary = { '\\omega' = { values = [0.5, 1, 2] } }\n\n[[claim]]"
    text = spring.replace("[[claim]]", row, 1).replace("id = 'at-once'", "id = 'at-once'\nfamilies = ['row']")
    pytester.makefile(".derivation.toml", spring=text.replace("expect = { fails = 'all' }", "expect = { fails = ['pulled', 'pushed'] }"))
    result = pytester.runpytest_subprocess("-p", "no:cacheprovider", "-k", "at-once")
    result.assert_outcomes(passed=2, failed=1, deselected=4)
    assert "rest/at-once on the family row: fails (sampled), which nothing expects" in result.stdout.str()


def test_folders_that_are_not_named_are_left_alone(pytester: pytest.Pytester, spring: str) -> None:
    pytester.makefile(".toml", settings=spring)
    assert pytester.runpytest_subprocess().ret == pytest.ExitCode.NO_TESTS_COLLECTED


def test_a_wrong_file_shows_its_problems(pytester: pytest.Pytester) -> None:
    pytester.makefile(".derivation.toml", broken="[derivation]\ntitle = 'x'\n")
    result = pytester.runpytest_subprocess()
    result.assert_outcomes(errors=1)
    result.stdout.fnmatch_lines(["*derivation::missing-key*", "*broken.derivation.toml:1:1*"])


def test_it_works_on_several_processes(project: pytest.Pytester) -> None:
    pytest.importorskip("xdist")
    project.runpytest_subprocess("-n", "2", "--dist", "loadfile").assert_outcomes(passed=11, failed=1)
