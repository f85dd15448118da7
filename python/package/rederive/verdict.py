"""Verdicts and strengths as enumerations whose truth value raises: an undecided claim cannot be counted as a yes."""

from __future__ import annotations

from enum import Enum
from typing import NoReturn

__all__ = ["Decision", "Strength", "Verdict"]


class Word(Enum):
    """A word of the report, of which there is no truth value."""

    def __bool__(self) -> NoReturn:
        name = type(self).__name__
        raise TypeError(f"a {name} is neither true nor false: compare it, for instance `is {name}.{type(self)._member_names_[0]}`")

    def __str__(self) -> str:
        return str(self.value)


class Verdict(Word):
    """What is said of a claim on a motion."""

    HOLDS = "holds"
    FAILS = "fails"
    NOT_APPLICABLE = "not-applicable"
    UNDECIDED = "undecided"


class Strength(Word):
    """How strong a verdict is."""

    SAMPLED = "sampled"
    """At finitely many times, with error bounds."""
    ENCLOSED = "enclosed"
    """At every time of the span, by intervals."""
    CERTIFIED = "certified"
    """It fails, and enclosures show it."""
    PROVED = "proved"
    """It follows for all values."""


class Decision(Word):
    """What is said of an equation for all values of its symbols."""

    PROVED = "proved"
    PROVED_EXCEPT = "proved except"
    """Proved but for cases that are named."""
    PROVED_UNREPLAYED = "proved unreplayed"
    """Proved by the prover alone: the checker has not replayed it."""
    REFUTED = "refuted"
    UNDECIDED = "undecided"

    @classmethod
    def of(cls, standing: str) -> Decision:
        """Of the word of a report: what rests on something open is not proved without exception."""
        if standing.endswith(" unreplayed"):
            return cls.PROVED_UNREPLAYED
        return cls.PROVED_EXCEPT if standing == "proved given" else cls(standing)
