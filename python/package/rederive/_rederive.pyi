from os import PathLike
from typing import Callable, Optional, Union

__version__: str

class Session:
    def __new__(cls, name: str = "", text: Optional[str] = None, log: Optional[str] = None) -> Session: ...
    def pairs(self) -> list[tuple[str, Optional[str], list[str]]]: ...
    def check(
        self,
        claims: list[str],
        trajectories: list[str],
        sampled: bool,
        only_verdicts: bool,
        deadline: Optional[float] = None,
        memory: Optional[int] = None,
        cache: tuple[bool, Optional[str]] = (True, None),
        progress: Optional[Callable[[int, int], object]] = None,
    ) -> Findings: ...
    def prove(
        self,
        formula: str,
        symbols: list[str],
        given: list[str],
        throughout: bool,
        scope: Optional[str] = None,
        deadline: Optional[float] = None,
    ) -> tuple[str, str, Optional[str]]: ...

class Findings:
    def document(self, format: str) -> str: ...
    def explanation(self, claim: str) -> Optional[str]: ...
    def curve(self, claim: str, reading: Optional[str], trajectory: str) -> Optional[tuple[str, list[list[float]]]]: ...

def lint_paper(
    name: str, text: Optional[str] = None, deadline: Optional[float] = None, log: Optional[str] = None
) -> tuple[str, list[str], str]: ...
def command(line: list[Union[str, PathLike[str]]]) -> int: ...

def sweep(
    session: Session, family: str, number: int, of: int, progress: Optional[Callable[[int, int], object]] = None
) -> str: ...
def join(session: Session, parts: list[str]) -> Findings: ...
