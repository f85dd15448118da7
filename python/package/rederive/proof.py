"""What was decided of an equation for all values of its symbols."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Mapping, NoReturn, Optional

from . import display
from .verdict import Decision

if TYPE_CHECKING:
    import pandas

__all__ = ["Counterexample", "Proof", "Proofs"]


@dataclass(frozen=True)
class Counterexample:
    """A point at which the equation fails; numbers as they are written, exact where they can be."""

    left: str
    right: str
    point: Mapping[str, str] = field(hash=False)
    equation: int = 0
    """Of several equations, which one fails; counted from 0. One between complex numbers counts as two, Re and Im."""


@dataclass(frozen=True)
class Proof:
    """The answer of :func:`rederive.prove`."""

    formula: str
    given: tuple[str, ...]
    verdict: Decision
    conditions: tuple[str, ...]
    """What has to hold for the formulas to have values."""
    exceptions: tuple[str, ...]
    """What the proof does not reach."""
    reason: Optional[str]
    counterexample: Optional[Counterexample]
    certificate: Optional[str]
    """An exact proof, as a program for SymPy."""
    log2_error: Optional[float]
    """log2 of the bound for the probability that a proof by random evaluation is wrong."""
    text: str = field(compare=False)
    """The answer as the command line prints it."""
    data: Mapping[str, Any] = field(hash=False, repr=False)
    """The whole answer, as ``rederive prove --format json`` prints it."""
    mathml: Optional[str] = field(default=None, compare=False, repr=False)
    """The formula as it was read, for a browser."""

    @classmethod
    def of(cls, document: str, text: str, mathml: Optional[str] = None) -> Proof:
        """From what the library tells."""
        data = json.loads(document)
        witness = data["witness"]
        return cls(
            formula=data["formula"],
            given=tuple(data["given"]),
            verdict=Decision.of(data["standing"]),
            conditions=tuple(data["conditions"]),
            exceptions=tuple(data["exceptions"]),
            reason=data["reason"],
            counterexample=witness
            and Counterexample(witness["left"], witness["right"], witness["point"], witness["equation"]),
            certificate=data["certificate"],
            log2_error=data["log2_error"],
            text=text,
            data=data,
            mathml=mathml,
        )

    def __bool__(self) -> NoReturn:
        raise TypeError("a Proof is neither true nor false: compare its verdict, for instance `is Decision.PROVED`")

    def __str__(self) -> str:
        return self.text

    def _repr_html_(self) -> str:
        return display.proof_html(self)

    def _repr_latex_(self) -> str:
        return display.latex(self.formula)


class Proofs(tuple[Proof, ...]):
    """The answers on a list of formulas, in their order."""

    __slots__ = ()

    def __bool__(self) -> NoReturn:
        raise TypeError("Proofs are neither true nor false: compare the verdict of each")

    def to_pandas(self) -> pandas.DataFrame:
        """A row for each formula; verdicts are words."""
        import pandas

        rows = [
            {
                "formula": one.formula,
                "verdict": str(one.verdict),
                "exceptions": "; ".join(one.exceptions) or None,
                "reason": one.reason,
                "point": dict(one.counterexample.point) if one.counterexample else None,
                "left": one.counterexample.left if one.counterexample else None,
                "right": one.counterexample.right if one.counterexample else None,
            }
            for one in self
        ]
        return pandas.DataFrame(rows, columns=["formula", "verdict", "exceptions", "reason", "point", "left", "right"])

    def __repr__(self) -> str:
        return "\n".join(f"{one.verdict!s:14} {one.formula}" for one in self)

    def _repr_html_(self) -> str:
        return display.proofs_html(self)
