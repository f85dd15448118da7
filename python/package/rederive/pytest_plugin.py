"""The plugin for pytest: a test for each claim on each motion of a derivation.

Collected are files ``*.derivation.toml``, and the ``*.toml`` of the folders that ``rederive_folders`` names (under
``[tool.pytest.ini_options]`` in ``pyproject.toml``). A test fails if the verdict is not as the file expects; where it
expects nothing, if the claim fails. What is undecided without being expected so is skipped, with the reason.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any, Iterator, Optional, Union

import pytest

from .display import correction_text, result_text
from .errors import Error
from .report import Correction, Report, Result
from .session import Session
from .verdict import Verdict

SUFFIX = ".derivation.toml"


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addini("rederive_folders", "folders whose *.toml are derivation files", type="args", default=[])
    parser.addini("rederive_rigor", "how much is asked of a verdict: enclosed or sampled", default="enclosed")


def pytest_collect_file(file_path: Path, parent: pytest.Collector) -> Optional[DerivationFile]:
    folders = [parent.config.rootpath / folder for folder in parent.config.getini("rederive_folders")]
    listed = file_path.suffix == ".toml" and any(folder in file_path.parents for folder in folders)
    if file_path.name.endswith(SUFFIX) or listed:
        made: DerivationFile = DerivationFile.from_parent(parent, path=file_path)
        return made
    return None


class DerivationFile(pytest.File):
    """A derivation file; it is read when it is collected, and checked when its first test runs."""

    _session: Optional[Session] = None
    _reports: dict[Optional[str], Union[Report, Error]]
    _corrections: dict[str, tuple[Correction, ...]]

    def collect(self) -> Iterator[Pair]:
        try:
            self._session = Session(self.path, name=str(self.path.relative_to(self.config.rootpath)))
        except (Error, UnicodeDecodeError, ValueError) as e:
            raise self.CollectError(str(e)) from None
        self._reports = {}
        self._corrections = {}
        for claim, trajectory in self._session.pairs:
            yield Pair.of(self, claim, trajectory)

    def found(self, claim: str, trajectory: Optional[str]) -> Result:
        """The verdict; all that is selected in this file is checked at once."""
        assert self._session is not None
        if None not in self._reports:
            mine = [item for item in self.session.items if isinstance(item, Pair) and item.parent is self]
            claims = list(dict.fromkeys(item.claim for item in mine))
            trajectories = list(dict.fromkeys(item.trajectory for item in mine if item.trajectory is not None))
            # A claim that is tried on some motions needs no others; a claim over ranges needs none.
            rigor: Any = self.config.getini("rederive_rigor")
            try:
                self._reports[None] = self._session.check(claims, trajectories, rigor, only_verdicts=True, progress=False)
            except Error as e:
                self._reports[None] = e
        report = self._reports[None]
        if isinstance(report, Error):
            raise report
        return report[claim, trajectory]

    def corrections(self, claim: str) -> tuple[Correction, ...]:
        """What holds instead of a claim that fails: it is looked for when a test of it has failed, once."""
        assert self._session is not None
        if claim not in self._corrections:
            rigor: Any = self.config.getini("rederive_rigor")
            try:
                self._corrections[claim] = self._session.check([claim], rigor=rigor, progress=False)[claim].corrections
            except Error:
                self._corrections[claim] = ()
        return self._corrections[claim]


class Unexpected(Exception):
    """A verdict that is not as expected."""


class Pair(pytest.Item):
    """One claim on one motion."""

    claim: str
    trajectory: Optional[str]
    parent: DerivationFile

    @classmethod
    def of(cls, file: DerivationFile, claim: str, trajectory: Optional[str]) -> Pair:
        name = claim if trajectory is None else f"{claim}[{trajectory}]"
        made: Pair = cls.from_parent(file, name=name)
        made.claim, made.trajectory = claim, trajectory
        return made

    def runtest(self) -> None:
        result = self.parent.found(self.claim, self.trajectory)
        if result.unexpected:
            corrections = self.parent.corrections(self.claim) if result.verdict is Verdict.FAILS else ()
            raise Unexpected("\n".join([result_text(result), *(f"  {correction_text(one)}" for one in corrections[:1])]))
        if result.verdict is Verdict.UNDECIDED and result.expected is None:
            pytest.skip(f"undecided: {result.reason}")

    def repr_failure(self, excinfo: pytest.ExceptionInfo[BaseException], style: Any = None) -> Any:
        if isinstance(excinfo.value, (Error, Unexpected)):
            return "\n".join(f"E   {line}" for line in str(excinfo.value).splitlines())
        return super().repr_failure(excinfo, style)

    def reportinfo(self) -> tuple[Path, Optional[int], str]:
        return self.path, None, f"{self.path.name}: {self.name}"
