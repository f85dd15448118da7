"""Questions to the library: :func:`check`, :func:`prove`, and :class:`Session` for several about one derivation."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Callable, Iterable, Literal, Optional, Union, overload

from . import _rederive
from .derivation import Derivation
from .formula import Names, is_sympy, relation
from .progress import Progress, shown
from .proof import Proof, Proofs
from .report import Report

__all__ = ["Session", "check", "prove"]

PathName = Union[str, "os.PathLike[str]"]
Where = Union[PathName, Derivation]
"""A path, or a derivation that was written in Python; a text is handed over as ``text=``."""
Rigor = Literal["enclosed", "sampled"]
Cache = Union[None, Literal[False], str, "os.PathLike[str]"]


@dataclass(frozen=True)
class _Asked:
    """A question with all that it depends on, so that it can be asked again elsewhere."""

    name: str
    text: str
    claims: tuple[str, ...]
    trajectories: tuple[str, ...]
    sampled: bool
    only_verdicts: bool
    deadline: Optional[float]
    memory: Optional[int]
    cache: tuple[bool, Optional[str]]

    def __call__(self) -> _rederive.Findings:
        return self.of(_rederive.Session(self.name, self.text), None)

    def of(self, session: _rederive.Session, progress: Optional[Callable[[int, int], object]]) -> _rederive.Findings:
        return session.check(
            list(self.claims),
            list(self.trajectories),
            self.sampled,
            self.only_verdicts,
            self.deadline,
            self.memory,
            self.cache,
            progress,
        )


@dataclass(frozen=True)
class _Joined:
    """Parts that were joined, so that they can be joined again elsewhere."""

    name: str
    text: str
    parts: tuple[str, ...]

    def __call__(self) -> _rederive.Findings:
        return _rederive.join(_rederive.Session(self.name, self.text), list(self.parts))


class Session:
    """A derivation that was read, for several questions about it.

    It is one of: ``derivation``, a path or a :class:`Derivation`; ``path=``, a path; ``text=``, the text of a derivation file, which
    is never taken for a path. Nothing is needed for :meth:`prove` alone: then ``log`` is what ``\\log`` is, ``"natural"`` or
    ``"decimal"``; unless given, what ``rederive.toml`` says. ``name`` is what it is called in messages.
    Raises :class:`DerivationError` with every problem of the text.
    """

    def __init__(
        self,
        derivation: Optional[Where] = None,
        name: Optional[str] = None,
        *,
        text: Optional[str] = None,
        path: Optional[PathName] = None,
        log: Optional[str] = None,
    ) -> None:
        self._name, self._text = _read(derivation, name, text, path)
        if self._text is not None and log is not None:
            raise TypeError("a derivation says itself what `log` is, under [conventions]")
        self._log = log
        self._read = _rederive.Session(self._name, self._text, log)

    def __reduce__(self) -> tuple[object, ...]:
        return (_again, (self._text, self._name, self._log))

    @property
    def source(self) -> tuple[str, str]:
        """The text of the derivation, and what it is called in messages."""
        return self._text or "", self._name

    @property
    def claims(self) -> tuple[str, ...]:
        """The names of the claims, ``id`` or ``id/reading``."""
        return tuple(_name(id, reading) for id, reading, _ in self._read.pairs())

    @property
    def pairs(self) -> tuple[tuple[str, Optional[str]], ...]:
        """Each claim with each trajectory that it is tried on; ``None`` for a claim over ranges."""
        of = [(_name(id, reading), on) for id, reading, on in self._read.pairs()]
        nowhere: list[Optional[str]] = [None]
        return tuple((name, one) for name, on in of for one in (list[Optional[str]](on) or nowhere))

    def change(
        self, derivation: Optional[Where] = None, *, text: Optional[str] = None, path: Optional[PathName] = None
    ) -> None:
        """Takes another state of the derivation; where this has problems, the state before is kept."""
        name, text = _read(derivation, self._name, text, path)
        if text is None:
            raise TypeError("another state is one of: the first argument, `text=`, `path=`")
        self._read = _rederive.Session(name, text)
        self._name, self._text = name, text

    def check(
        self,
        claims: Union[str, Iterable[str]] = (),
        trajectories: Union[str, Iterable[str]] = (),
        rigor: Rigor = "enclosed",
        *,
        only_verdicts: bool = False,
        deadline: Optional[float] = None,
        memory: Optional[int] = None,
        cache: Cache = None,
        progress: Progress = None,
    ) -> Report:
        """Tries the claims on the motions; see :func:`check`."""
        if rigor not in ("enclosed", "sampled"):
            raise ValueError(f"rigor is 'enclosed' or 'sampled', not {rigor!r}")
        if self._text is None:
            raise ValueError("there is nothing to check: the session has no derivation")
        sampled = rigor == "sampled"
        of = (_names(claims), _names(trajectories), sampled, only_verdicts, _seconds(deadline), memory, _cache(cache))
        asked = _Asked(self._name, self._text, *of)
        with shown(progress, self._name) as tell:
            found = asked.of(self._read, tell)
        return Report(found.document("json"), asked, found)

    def sweep(self, family: str, part: tuple[int, int] = (1, 1), *, progress: Progress = None) -> str:
        """Counts part ``(k, n)`` of the members of a family: the text of what ``rederive sweep`` writes.

        A part is small, a few hundred bytes for each claim, and the same wherever it is counted.
        """
        number, of = part
        with shown(progress, f"{family} {number}/{of}") as tell:
            return _rederive.sweep(self._read, family, number, of, tell)

    def merge(self, parts: Iterable[str]) -> Report:
        """Joins the parts of a family, in any order: what :meth:`check` finds on it with ``only_verdicts``.

        Raises :class:`PartError` where one is missing, comes twice, or belongs to something else.
        """
        if self._text is None:
            raise ValueError("there is nothing to join: the session has no derivation")
        joined = _Joined(self._name, self._text, tuple(parts))
        found = _rederive.join(self._read, list(joined.parts))
        return Report(found.document("json"), joined, found)

    def prove(
        self,
        formula: Any,
        symbols: Union[str, Iterable[str]] = (),
        given: Union[str, Iterable[Any]] = (),
        *,
        scope: Optional[str] = None,
        throughout: bool = False,
        deadline: Optional[float] = None,
    ) -> Proof:
        """Decides an equation with the symbols of the derivation; see :func:`prove`."""
        words = list(_names(symbols))
        premises: list[Any] = [given] if is_sympy(given) else list(_names(given))
        if is_sympy(formula):
            formula, words, premises = _of_sympy(formula, words, premises)
        elif not isinstance(formula, str):
            raise TypeError(
                f"a formula is a text in LaTeX, a relation of SymPy, or an expression of it, not {formula!r}"
                + (": `==` compares at once, an equation of SymPy is `Eq(…, …)`" if isinstance(formula, bool) else "")
            )
        return Proof.of(*self._read.prove(formula, words, premises, throughout, scope, _seconds(deadline)))


def check(
    derivation: Optional[Where] = None,
    claims: Union[str, Iterable[str]] = (),
    trajectories: Union[str, Iterable[str]] = (),
    rigor: Rigor = "enclosed",
    *,
    text: Optional[str] = None,
    path: Optional[PathName] = None,
    only_verdicts: bool = False,
    deadline: Optional[float] = None,
    memory: Optional[int] = None,
    cache: Cache = None,
    progress: Progress = None,
) -> Report:
    """Tries the claims of a derivation on its motions.

    ``derivation``: a path, or a :class:`Derivation`. In its place ``path=``, a path, or ``text=``, the text of a derivation file:
    a text is never taken for a path.
    ``claims``, ``trajectories``: only these, by name; all when empty. Families count among the trajectories.
    ``rigor``: ``"enclosed"`` looks at every time of the span where it is possible, ``"sampled"`` at finitely many.
    ``only_verdicts``: no altered formulas, no corrections, nothing that separates the motions.
    ``deadline``: after so many seconds nothing is begun; what is left is undecided.
    ``memory``: the same while the process holds so many bytes.
    ``cache``: the folder in which what is found is kept, and from which it is recalled; ``False`` for none. Unless given, that of
    the command line: what ``REDERIVE_CACHE`` names, nothing where it is empty; else that of the user for such things.
    ``progress``: ``True``, ``False``, a function of (done, of), or ``None``: a line on a terminal, a bar of tqdm in a notebook where
    tqdm is installed, nothing elsewhere.

    Raises :class:`DerivationError` with every problem of the text, and :class:`UnknownName`. An equation, or an expression of SymPy
    that should be zero, has no motions: :func:`prove` decides it.
    """
    if is_sympy(derivation):
        raise TypeError("an equation of SymPy has no motions: `prove` decides it; a claim of a `Derivation` takes it, too")
    return Session(derivation, text=text, path=path).check(
        claims,
        trajectories,
        rigor,
        only_verdicts=only_verdicts,
        deadline=deadline,
        memory=memory,
        cache=cache,
        progress=progress,
    )


@overload
def prove(  # pyright: ignore[reportOverlappingOverload]  # whatever else a formula may be, it is no list
    formula: Union[list[Any], tuple[Any, ...]],
    symbols: Union[str, Iterable[str]] = (),
    given: Union[str, Iterable[Any]] = (),
    *,
    throughout: bool = False,
    deadline: Optional[float] = None,
    log: Optional[str] = None,
    progress: Progress = None,
) -> Proofs: ...
@overload
def prove(
    formula: Any,
    symbols: Union[str, Iterable[str]] = (),
    given: Union[str, Iterable[Any]] = (),
    *,
    throughout: bool = False,
    deadline: Optional[float] = None,
    log: Optional[str] = None,
    progress: Progress = None,
) -> Proof: ...
def prove(
    formula: Any,
    symbols: Union[str, Iterable[str]] = (),
    given: Union[str, Iterable[Any]] = (),
    *,
    throughout: bool = False,
    deadline: Optional[float] = None,
    log: Optional[str] = None,
    progress: Progress = None,
) -> Union[Proof, Proofs]:
    """Decides an equation for all values of its symbols; of a list each by itself.

    ``formula``: an equation in LaTeX; several are separated by commas, and all must hold. Or an ``Eq`` of SymPy, or an expression of
    SymPy, which is asked to be zero: its symbols are declared with their assumptions then, and premises may be relations of SymPy.
    Functions in it are fields, and what they are functions of, or derived by, are coordinates. Or a list of such formulas: then
    the answer is :class:`Proofs`, one of each, in their order; a formula that cannot be read ends it.
    ``symbols``: declarations, in the words of ``rederive prove --symbol``: ``"x"``, ``"x, y: positive"``, ``"q: state"``;
    in a list those of the texts, since expressions of SymPy bring theirs along.
    ``given``: premises, relations in LaTeX.
    ``throughout``: of ± one sign must serve all points.
    ``deadline``: after so many seconds :class:`DeadlineReached` is raised; of a list each formula has so many.
    ``log``: what ``\\log`` is, ``"natural"`` or ``"decimal"``; unless given, what ``rederive.toml`` says, or else it is not read.
    ``progress``: of a list, how many are done; as for :func:`check`.
    """
    session = Session(log=log)
    if not isinstance(formula, (list, tuple)):
        return session.prove(formula, symbols, given, throughout=throughout, deadline=deadline)
    # What can be gone through once only is asked of every formula.
    symbols, given = _names(symbols), given if is_sympy(given) else _names(given)
    found = []
    with shown(progress, "prove", "formulas") as tell:
        for one in formula:
            # Expressions of SymPy bring their symbols along.
            words = () if is_sympy(one) else symbols
            found.append(session.prove(one, words, given, throughout=throughout, deadline=deadline))
            if tell is not None:
                tell(len(found), len(formula))
    return Proofs(found)


def _again(text: Optional[str], name: str, log: Optional[str]) -> Session:
    return Session(text=text, name=name, log=log)


def _name(id: str, reading: Optional[str]) -> str:
    return id if reading is None else f"{id}/{reading}"


def _names(names: Union[str, Iterable[Any]]) -> tuple[Any, ...]:
    return (names,) if isinstance(names, str) else tuple(names)


def _seconds(deadline: Optional[float]) -> Optional[float]:
    """A deadline that is over already is one, too; the library knows none below zero."""
    if deadline is not None and deadline != deadline:
        raise ValueError("the deadline is not a number")
    return None if deadline is None else max(float(deadline), 0.0)


def _cache(cache: Cache) -> tuple[bool, Optional[str]]:
    """Whether what is found is kept, and in which folder, where one is named."""
    return cache is not False, None if cache is None or cache is False else os.path.abspath(cache)


def _of_sympy(formula: Any, words: list[str], given: list[Any]) -> tuple[str, list[str], list[str]]:
    """An equation of SymPy with its symbols, and what is assumed of them."""
    names, formula = Names(), relation(formula)
    declared, assumed = names.premises([formula, *(one for one in given if is_sympy(one))])
    premises = [names.latex(one) if is_sympy(one) else str(one) for one in given]
    return names.latex(formula), words + declared, premises + assumed


def _read(
    derivation: Optional[Where], name: Optional[str], text: Optional[str], path: Optional[PathName]
) -> tuple[str, Optional[str]]:
    """The name and the text of a derivation; no text where nothing is handed over."""
    if sum(one is not None for one in (derivation, text, path)) > 1:
        raise TypeError("a derivation is one of: the first argument, `text=`, `path=`")
    if text is not None:
        if not isinstance(text, str):
            raise TypeError(f"`text=` is the text of a derivation file, not {type(text).__name__}")
        return name or "derivation", text
    if isinstance(derivation, Derivation):
        return name or "derivation", derivation.to_toml()
    if isinstance(derivation, str) and "\n" in derivation:
        raise TypeError("this is a text, and a path is expected here: hand it over as `text=`")
    at = derivation if path is None else path
    if at is None:
        return name or "", None
    return name or str(at), Path(at).read_text(encoding="utf-8")
