"""``%load_ext rederive``: a cell that begins with ``%%rederive`` is checked, and what was found is shown.

    %%rederive NAME --claim ID --trajectory ID --sampled --deadline SECONDS

A cell with the line ``[derivation]`` is the text of a derivation file; its :class:`Report` is kept as NAME, ``report`` unless
given. Every other cell is LaTeX, of which :class:`Lint` says what follows and what is wrong; it is kept as NAME, ``found`` unless given.
"""

from __future__ import annotations

import argparse
from typing import Any, NoReturn, Union

from .errors import Error
from .paper import Lint, lint
from .report import Report
from .session import Session

__all__ = ["load_ipython_extension"]

Found = Union[Report, Lint]


class _Words(argparse.ArgumentParser):
    """What is wrong in the first line of a cell is an exception: a parser for a command line would end the notebook's process."""

    def error(self, message: str) -> NoReturn:
        raise Error(f"{message}\n{self.format_usage()}")


def _name(text: str) -> str:
    if not text.isidentifier():
        raise argparse.ArgumentTypeError(f"{text!r} is no name in Python")
    return text


def _arguments(line: str) -> argparse.Namespace:
    parser = _Words(prog="%%rederive", add_help=False)
    parser.add_argument("name", nargs="?", type=_name)
    parser.add_argument("--claim", action="append", default=[])
    parser.add_argument("--trajectory", action="append", default=[])
    parser.add_argument("--sampled", action="store_true")
    parser.add_argument("--deadline", type=float)
    return parser.parse_args(line.split())


def run(line: str, cell: str, namespace: dict[str, Any]) -> Found:
    """Checks the text of a cell."""
    derivation = any(one.strip() == "[derivation]" for one in cell.splitlines())
    try:
        asked = _arguments(line)
        name = asked.name or ("report" if derivation else "found")
        namespace[name] = _checked(asked, f"{name}.toml", cell) if derivation else _looked_through(asked, cell)
    except Error as e:
        # As a notebook shows it: no trace of calls.
        shown = [str(e)]
        e._render_traceback_ = lambda: shown  # type: ignore[attr-defined]
        raise
    found: Found = namespace[name]
    return found


def _checked(asked: argparse.Namespace, name: str, cell: str) -> Report:
    rigor: Any = "sampled" if asked.sampled else "enclosed"
    return Session(text=cell, name=name).check(asked.claim, asked.trajectory, rigor, deadline=asked.deadline)


def _looked_through(asked: argparse.Namespace, cell: str) -> Lint:
    if asked.claim or asked.trajectory or asked.sampled:
        raise Error("a cell of LaTeX has no claims and no trajectories: those are of a derivation file, with its line [derivation]")
    return lint(text=cell, deadline=asked.deadline)


def load_ipython_extension(ipython: Any) -> None:
    """Makes the magic known; Python calls this for ``%load_ext rederive``."""

    def rederive(line: str, cell: str) -> Found:
        return run(line, cell, ipython.user_ns)

    ipython.register_magic_function(rederive, "cell", "rederive")
