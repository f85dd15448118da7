"""What a check found: :class:`Report`, with a :class:`Claim` for each claim and a :class:`Result` for each motion of it."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Callable, Iterator, Mapping, NoReturn, Optional, Union, overload

from . import _rederive, display, plotting
from .errors import UnknownName
from .verdict import Decision, Strength, Verdict

if TYPE_CHECKING:
    import numpy
    import pandas
    from matplotlib.axes import Axes

__all__ = ["Claim", "Correction", "Curve", "Exclusion", "Members", "Report", "Residual", "Result", "Summary", "Witness"]

Side = Union[float, tuple[float, float], None]


@dataclass(frozen=True)
class Witness:
    """A point that can be checked by hand."""

    t: Optional[float]
    """The time; ``None`` for a claim over ranges."""
    formula: str
    left: Side
    """Value of the left side; over ranges the interval that it lies in; ``None`` where it has none."""
    right: Side
    bound: Optional[float]
    """Error bound of the difference."""
    values: Mapping[str, float] = field(hash=False)
    """What the two sides depend on."""


@dataclass(frozen=True)
class Residual:
    """The worst point of a comparison."""

    max: Optional[float]
    bound: Optional[float]
    at: Optional[float]


@dataclass(frozen=True)
class Exclusion:
    """A stretch of time that was left out, and why."""

    start: Optional[float]
    end: Optional[float]
    reason: str


@dataclass(frozen=True)
class Members:
    """How many members of a family there are of each kind."""

    count: int
    """How many were tried."""
    holds: int
    fails: int
    not_applicable: int
    undecided: int
    rejected: int
    """Draws that are no members."""
    failing_at_most: Optional[float]
    """Where everything is drawn: the share of all such motions that fail is no larger, ..."""
    confidence: Optional[float]
    """... with this confidence."""


@dataclass(frozen=True)
class Result:
    """One claim on one motion, on a family of them, or over its ranges."""

    claim: str
    """Its id, or ``id/reading``."""
    trajectory: Optional[str]
    """``None`` for a family, and for a claim over ranges."""
    verdict: Verdict
    strength: Optional[Strength]
    expected: Optional[Verdict]
    """What the file expects, if it expects something."""
    unexpected: bool
    """Whether the verdict is not as expected; without an expectation, whether the claim fails."""
    reason: Optional[str] = None
    witness: Optional[Witness] = None
    residual: Optional[Residual] = None
    samples: Optional[int] = None
    branch: Optional[str] = None
    excluded: tuple[Exclusion, ...] = ()
    family: Optional[str] = None
    """The family, where the claim was tried on one; the witness is of the member that fails most clearly."""
    members: Optional[Members] = None

    @property
    def on(self) -> Optional[str]:
        """The trajectory or the family; ``None`` for a claim over ranges."""
        return self.family if self.trajectory is None else self.trajectory

    def __bool__(self) -> NoReturn:
        raise TypeError("a Result is neither true nor false: compare its `verdict`, or ask `unexpected`")

    def __str__(self) -> str:
        return display.result_text(self)

    def _repr_html_(self) -> str:
        return display.result_html(self)


@dataclass(frozen=True)
class Correction:
    """A formula that holds where the printed one fails."""

    printed: str
    formula: str
    edits: tuple[str, ...]
    """What was edited: ``sign``, ``factor``, ``missing``, ..."""
    strength: Strength
    """How it is known: the weakest strength with which it holds on a motion; *proved* where it follows for all values."""
    holds_on: int
    """On how many motions it holds: on all to which the claim applies; 0 where it holds over ranges."""

    def __bool__(self) -> NoReturn:
        raise TypeError("a Correction is neither true nor false: look at its `strength`")

    def __str__(self) -> str:
        return display.correction_text(self)


@dataclass(frozen=True)
class Claim:
    """A claim with all that was found of it."""

    id: str
    reading: Optional[str]
    says: str
    formulas: tuple[str, ...]
    assumptions: tuple[str, ...]
    decision: Optional[Decision]
    """Whether it holds for all values, where that was asked."""
    results: tuple[Result, ...]
    corrections: tuple[Correction, ...] = ()
    """Where it fails: what holds instead, the closest to the print first. None are looked for by ``only_verdicts``."""

    @property
    def name(self) -> str:
        """The id, or ``id/reading``."""
        return self.id if self.reading is None else f"{self.id}/{self.reading}"

    def __getitem__(self, on: Optional[str]) -> Result:
        for result in self.results:
            if result.on == on:
                return result
        raise UnknownName(f"{self.name} on {on}")

    def __iter__(self) -> Iterator[Result]:
        return iter(self.results)

    def __len__(self) -> int:
        return len(self.results)

    def __bool__(self) -> NoReturn:
        raise TypeError("a Claim is neither true nor false: look at the `verdict` of its results")


@dataclass(frozen=True)
class Summary:
    """How many verdicts there are of each kind."""

    holds: int
    fails: int
    not_applicable: int
    undecided: int
    unexpected: int


@dataclass(frozen=True)
class Curve:
    """Both sides of the deciding comparison along a motion, at the samples that were kept."""

    formula: str
    t: numpy.ndarray[Any, numpy.dtype[numpy.float64]]
    left: numpy.ndarray[Any, numpy.dtype[numpy.float64]]
    right: numpy.ndarray[Any, numpy.dtype[numpy.float64]]
    residual: numpy.ndarray[Any, numpy.dtype[numpy.float64]]
    """abs(left - right)"""
    bound: numpy.ndarray[Any, numpy.dtype[numpy.float64]]
    """The error bound of the residual."""
    limit: numpy.ndarray[Any, numpy.dtype[numpy.float64]]
    """The largest bound that counts as evidence."""


Again = Callable[[], _rederive.Findings]
Rows = tuple[str, list[list[float]]]


class Report:
    """What a check found. Two reports are equal if their documents are."""

    def __init__(self, document: str, again: Again, found: Optional[_rederive.Findings] = None) -> None:
        self._document = document
        self._again = again
        self._found = found
        self.data: dict[str, Any] = json.loads(document)
        """The whole document ``report.json``, see the page on schemas."""
        self.claims: tuple[Claim, ...] = tuple(_claim(one) for one in self.data["claims"])

    @property
    def title(self) -> str:
        return str(self.data["derivation"]["title"])

    @property
    def results(self) -> tuple[Result, ...]:
        """Everything that was found, in the order of the file."""
        return tuple(result for claim in self.claims for result in claim.results)

    @property
    def unexpected(self) -> tuple[Result, ...]:
        """What is not as the file expects; where it expects nothing, what fails."""
        return tuple(result for result in self.results if result.unexpected)

    @property
    def summary(self) -> Summary:
        return Summary(**self.data["summary"])

    @overload
    def __getitem__(self, name: str) -> Claim: ...
    @overload
    def __getitem__(self, name: tuple[str, Optional[str]]) -> Result: ...
    def __getitem__(self, name: Union[str, tuple[str, Optional[str]]]) -> Union[Claim, Result]:
        if isinstance(name, tuple):
            return self[name[0]][name[1]]
        for claim in self.claims:
            if claim.name == name:
                return claim
        readings = [claim.name for claim in self.claims if claim.id == name]
        if readings:
            raise UnknownName(name, f"`{name}` has readings, name one of them: `{'`, `'.join(readings)}`")
        raise UnknownName(name)

    def __iter__(self) -> Iterator[Claim]:
        return iter(self.claims)

    def __len__(self) -> int:
        return len(self.claims)

    def __bool__(self) -> NoReturn:
        raise TypeError("a Report is neither true nor false: ask for `unexpected`, or for the verdict of a claim")

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Report) and self.data == other.data

    def __hash__(self) -> int:
        return hash(self._document)

    def __getstate__(self) -> tuple[str, Again]:
        return self._document, self._again

    def __setstate__(self, state: tuple[str, Again]) -> None:
        self.__init__(*state)  # type: ignore[misc]

    def json(self) -> str:
        """The document ``report.json``, byte for byte as the program writes it."""
        return self._document

    def page(self) -> str:
        """The page for a browser, in one file."""
        return self._findings().document("page")

    def markdown(self) -> str:
        return self._findings().document("markdown")

    def latex(self) -> str:
        """The report as LaTeX source, for an appendix or a letter."""
        return self._findings().document("latex")

    def explain(self, claim: str) -> str:
        """How the verdicts on a claim came about, as ``rederive explain`` prints it: ``id``, for all its readings, or ``id/reading``.

        Raises :class:`UnknownName` where there is no verdict on such a claim.
        """
        told = self._findings().explanation(claim)
        if told is None:
            raise UnknownName(claim, f"there is no verdict on a claim `{claim}`")
        return told

    def curve(self, claim: str, trajectory: str) -> Curve:
        """Both sides of the deciding comparison along a motion, as NumPy arrays.

        Raises :class:`UnknownName` where there is no such pair, or nothing was compared at times.
        """
        import numpy

        formula, rows = self._rows(claim, trajectory)
        columns = numpy.array(rows, dtype=numpy.float64).reshape(-1, 6).T.copy()
        return Curve(formula, *columns)

    def _rows(self, claim: str, trajectory: str) -> Rows:
        of = self[claim]
        rows = self._findings().curve(of.id, of.reading, trajectory)
        if rows is None:
            _ = of[trajectory]
            raise UnknownName(claim, f"there is no curve of `{claim}` on `{trajectory}`: nothing was compared at times of one motion")
        return rows

    def _findings(self) -> _rederive.Findings:
        # A report that was pickled computes its curves and pages again: the same text gives the same.
        if self._found is None:
            self._found = self._again()
        return self._found

    def to_pandas(self) -> pandas.DataFrame:
        """A row for each result; verdicts and strengths are words."""
        import pandas

        def word(value: object) -> Optional[str]:
            return None if value is None else str(value)

        rows = [
            {
                "claim": r.claim,
                "trajectory": r.trajectory,
                "family": r.family,
                "verdict": word(r.verdict),
                "strength": word(r.strength),
                "expected": word(r.expected),
                "unexpected": r.unexpected,
                "residual": r.residual.max if r.residual else None,
                "bound": r.residual.bound if r.residual else None,
                "reason": r.reason,
            }
            for r in self.results
        ]
        names = ["claim", "trajectory", "family", "verdict", "strength", "expected", "unexpected", "residual", "bound", "reason"]
        return pandas.DataFrame(rows, columns=names)

    def plot(self, claim: str, trajectory: str, axes: Optional[Axes] = None) -> Axes:
        """Draws both sides along a motion with matplotlib, the error bound as a band."""
        return plotting.draw(self.curve(claim, trajectory), f"{claim} on {trajectory}", axes)

    def __repr__(self) -> str:
        s = self.summary
        counts = f"{s.holds} hold, {s.fails} fail, {s.not_applicable} do not apply, {s.undecided} undecided"
        return f"<Report of {self.title!r}: {counts}; {s.unexpected} not as expected>"

    def __str__(self) -> str:
        return display.report_text(self)

    def _repr_html_(self) -> str:
        return display.report_html(self, self._rows)


def _claim(data: dict[str, Any]) -> Claim:
    name = data["id"] if data["reading"] is None else f"{data['id']}/{data['reading']}"
    results = [_result(name, one) for one in data["results"]]
    results += [_on_family(name, one) for one in data.get("families", ())]
    if data["region"] is not None:
        results.append(_over_ranges(name, data["region"]))
    return Claim(
        id=data["id"],
        reading=data["reading"],
        says=data["says"],
        formulas=tuple(data["formulas"]),
        assumptions=tuple(data["assumptions"]),
        decision=None if data["identity"] is None else Decision.of(data["identity"]["standing"]),
        results=tuple(results),
        corrections=_corrections(data["variants"]),
    )


def _corrections(variants: Optional[dict[str, Any]]) -> tuple[Correction, ...]:
    erratum = None if variants is None else variants["erratum"]
    return () if erratum is None else tuple(_correction(one) for one in erratum["corrections"])


def _correction(data: dict[str, Any]) -> Correction:
    return Correction(
        printed=data["printed"],
        formula=data["formula"],
        edits=tuple(data["classes"]),
        strength=Strength(data["strength"]),
        holds_on=data["holds_on"],
    )


def _verdict(word: Optional[str]) -> Optional[Verdict]:
    return None if word is None else Verdict(word)


def _strength(word: Optional[str]) -> Optional[Strength]:
    return None if word is None else Strength(word)


def _result(claim: str, data: dict[str, Any]) -> Result:
    residual = data["residual"]
    return Result(
        claim=claim,
        trajectory=data["trajectory"],
        verdict=Verdict(data["verdict"]),
        strength=_strength(data["strength"]),
        expected=_verdict(data["expected"]),
        unexpected=data["unexpected"],
        reason=data["reason"],
        witness=_witness(data["witness"]),
        residual=residual and Residual(**residual),
        samples=data["samples"],
        branch=data["branch"],
        excluded=tuple(Exclusion(e["from"], e["to"], e["reason"]) for e in data["excluded"]),
    )


def _witness(data: Optional[dict[str, Any]]) -> Optional[Witness]:
    if data is None:
        return None
    return Witness(**{key: data[key] for key in ("t", "formula", "left", "right", "bound", "values")})


def _on_family(claim: str, data: dict[str, Any]) -> Result:
    share, clearest = data["failing_share"] or {}, data["clearest_failing"] or {}
    return Result(
        claim=claim,
        trajectory=None,
        verdict=Verdict(data["verdict"]),
        strength=_strength(data["strength"]),
        expected=_verdict(data["expected"]),
        unexpected=data["unexpected"],
        reason=data["reason"],
        witness=_witness(clearest.get("witness")),
        family=data["family"],
        members=Members(
            count=data["members"],
            holds=data["holds"],
            fails=data["fails"],
            not_applicable=data["not_applicable"],
            undecided=data["undecided"],
            rejected=data["rejected"],
            failing_at_most=share.get("at_most"),
            confidence=share.get("confidence"),
        ),
    )


def _over_ranges(claim: str, data: dict[str, Any]) -> Result:
    def side(interval: Optional[list[float]]) -> Side:
        return None if interval is None else (interval[0], interval[1])

    witness = data["witness"]
    return Result(
        claim=claim,
        trajectory=None,
        verdict=Verdict(data["verdict"]),
        strength=_strength(data["strength"]),
        expected=_verdict(data["expected"]),
        unexpected=data["unexpected"],
        reason=data["reason"],
        witness=witness
        and Witness(None, witness["formula"], side(witness["left"]), side(witness["right"]), None, witness["values"]),
    )
