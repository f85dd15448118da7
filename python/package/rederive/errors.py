"""What can go wrong, as exceptions.

A problem of a text has its place, the line with a caret under it, and a hint; see :class:`Problem`.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Optional

__all__ = ["Cancelled", "DeadlineReached", "Defect", "DerivationError", "Error", "NoCounterpart", "PartError", "Problem", "UnknownName"]


class Error(Exception):
    """Every exception of this package."""


@dataclass(frozen=True)
class Problem:
    """A problem at a place of a text."""

    code: str
    """Its stable name, for instance ``latex::unknown-symbol``."""
    message: str
    """What is wrong, in one sentence."""
    path: str
    """The file, or what the text is called."""
    line: Optional[int]
    """Counted from 1; ``None`` where the whole file is meant."""
    column: Optional[int]
    """Counted from 1, in characters."""
    hint: Optional[str]
    """What to do about it."""
    text: str
    """All of it, with the line and a caret."""

    def __str__(self) -> str:
        return self.text


class DerivationError(Error):
    """What is wrong in a derivation or a formula: one :class:`Problem` or more, each with its place."""

    def __init__(self, problems: tuple[Problem, ...]) -> None:
        super().__init__(problems)
        self.problems = problems

    @classmethod
    def of(cls, found: list[tuple[Any, ...]]) -> DerivationError:
        """From what the library tells."""
        return cls(tuple(Problem(*one) for one in found))

    def __str__(self) -> str:
        return "\n\n".join(problem.text for problem in self.problems)


class UnknownName(Error, KeyError):
    """There is no claim, reading or motion of this name; a second argument says it in other words."""

    def __str__(self) -> str:
        name, *words = self.args
        return str(words[0]) if words else f"there is no claim or trajectory `{name}`"


class Cancelled(Error):
    """The run was ended from outside."""

    def __str__(self) -> str:
        return "the run was cancelled"


class DeadlineReached(Error, TimeoutError):
    """The answer was not found in time."""

    def __str__(self) -> str:
        return "the deadline was reached before there was an answer"


class PartError(Error, ValueError):
    """Parts of a family that cannot be joined: one is missing, comes twice, is damaged or belongs to something else."""


class NoCounterpart(Error, ValueError):
    """An expression of SymPy that the formula language cannot say."""


class Defect(Error, RuntimeError):
    """The program contradicts itself: please report it, with the text that it was about."""

    def __str__(self) -> str:
        return f"a defect of rederive, not of your text: {self.args[0]}"
