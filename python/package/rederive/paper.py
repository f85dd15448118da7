"""Papers and pieces of LaTeX, looked through formula by formula: :func:`lint`."""

from __future__ import annotations

import json
import os
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Iterator, Mapping, NoReturn, Optional, Union

from . import _rederive, display

if TYPE_CHECKING:
    import pandas

__all__ = ["Lint", "Relation", "lint"]


@dataclass(frozen=True)
class Relation:
    """A formula that a paper prints, and what is known of it."""

    verdict: str
    """``follows_proved``, ``holds_in_numbers``, ``wrong_refuted_by_a_point``, ``differs``, ``defines``, ``condition``,
    ``approximates``, ``not_followed`` or ``not_read``: what is not followed is not confirmed."""
    file: str
    line: int
    """Counted from 1."""
    formula: str
    """LaTeX."""
    label: Optional[str]
    why: str
    message: Optional[str]
    """Of a wrong step: the point, and what the two sides are there."""
    instead: Optional[str]
    """Of a wrong step: the side as it should be, which is proved."""
    inline: bool
    """Whether it stands in the running text."""
    markup: str = field(compare=False, repr=False)
    """The formula for a browser: MathML, where it is read."""
    data: Mapping[str, Any] = field(hash=False, repr=False)
    """All of it, as ``rederive lint --format json`` prints it."""

    def __bool__(self) -> NoReturn:
        raise TypeError("a Relation is neither true nor false: compare its `verdict`")

    def _repr_latex_(self) -> str:
        return display.latex(self.formula)


class Lint:
    """What was found in a paper, relation by relation, in their order."""

    def __init__(self, document: str, markup: list[str], page: str) -> None:
        self._parts = (document, markup, page)
        self.data: dict[str, Any] = json.loads(document)
        """What ``rederive lint --format json`` prints."""
        names = ("verdict", "file", "line", "formula", "label", "why", "message", "instead", "inline")
        self.relations: tuple[Relation, ...] = tuple(
            Relation(**{name: one[name] for name in names}, markup=shown, data=one)
            for one, shown in zip(self.data["relations"], markup)
        )

    @property
    def name(self) -> str:
        return str(self.data["paper"])

    @property
    def words(self) -> dict[str, int]:
        """How often each word is said."""
        return dict(self.data["words"])

    @property
    def wrong(self) -> tuple[Relation, ...]:
        """The steps that a point refutes, each with what is proved in its place."""
        return tuple(one for one in self.relations if one.verdict == "wrong_refuted_by_a_point")

    def page(self) -> str:
        """The page of ``rederive lint --html``, in one file."""
        return self._parts[2]

    def to_pandas(self) -> pandas.DataFrame:
        """A row for each relation."""
        import pandas

        names = ["line", "verdict", "formula", "why", "instead", "label", "inline", "file"]
        return pandas.DataFrame([{name: getattr(one, name) for name in names} for one in self.relations], columns=names)

    def __iter__(self) -> Iterator[Relation]:
        return iter(self.relations)

    def __len__(self) -> int:
        return len(self.relations)

    def __bool__(self) -> NoReturn:
        raise TypeError("a Lint is neither true nor false: look at `wrong`, or at the verdict of a relation")

    def __reduce__(self) -> tuple[object, ...]:
        return (Lint, self._parts)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Lint) and self.data == other.data

    def __hash__(self) -> int:
        return hash(self._parts[0])

    def __repr__(self) -> str:
        return f"<Lint of {self.name!r}: {display.lint_words(self)}>"

    def __str__(self) -> str:
        return display.lint_text(self)

    def _repr_html_(self) -> str:
        return display.lint_html(self)


def lint(
    path: Union[None, str, os.PathLike[str]] = None,
    *,
    text: Optional[str] = None,
    deadline: Optional[float] = None,
    log: Optional[str] = None,
) -> Lint:
    """Says of every relation that a paper prints whether it follows, holds in numbers, is wrong, or is not followed.

    ``path``: a paper in LaTeX, or Markdown with formulas between dollars; files that it names are read inside of its folder.
    ``text``: in its place LaTeX; where nothing in it says where formulas begin, it is formulas, one in a line, or a chain whose
    lines end with ``\\\\``. A text is never taken for a path.
    ``deadline``: after so many seconds :class:`DeadlineReached` is raised.
    ``log``: what ``\\log`` is, ``"natural"`` or ``"decimal"``; unless given, what ``rederive.toml`` says, or else a formula with it
    is not read.

    Raises :class:`DerivationError` where the paper cannot be read.
    """
    if (path is None) == (text is None):
        raise TypeError("one of `path` and `text` is looked through")
    if path is not None:
        # What is not there is told as Python tells it.
        os.stat(path)
    return Lint(*_rederive.lint_paper("text" if path is None else os.fspath(path), text, deadline, log))
