"""``%load_ext rederive``: a cell that begins with ``%%rederive`` holds the text of a derivation, and shows its report.

    %%rederive NAME --claim ID --trajectory ID --sampled

The report is kept as NAME, ``report`` unless given.
"""

from __future__ import annotations

import argparse
from typing import Any, NoReturn, Optional

from .errors import Error
from .report import Report
from .session import Session

__all__ = ["load_ipython_extension"]


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
    parser.add_argument("name", nargs="?", default="report", type=_name)
    parser.add_argument("--claim", action="append", default=[])
    parser.add_argument("--trajectory", action="append", default=[])
    parser.add_argument("--sampled", action="store_true")
    parser.add_argument("--deadline", type=float)
    return parser.parse_args(line.split())


def run(line: str, cell: str, namespace: dict[str, Any]) -> Optional[Report]:
    """Checks the text of a cell."""
    try:
        asked = _arguments(line)
        report = Session(cell + "\n", name=f"{asked.name}.toml").check(
            asked.claim, asked.trajectory, "sampled" if asked.sampled else "enclosed", deadline=asked.deadline
        )
    except Error as e:
        # As a notebook shows it: no trace of calls.
        shown = [str(e)]
        e._render_traceback_ = lambda: shown  # type: ignore[attr-defined]
        raise
    namespace[asked.name] = report
    return report


def load_ipython_extension(ipython: Any) -> None:
    """Makes the magic known; Python calls this for ``%load_ext rederive``."""

    def rederive(line: str, cell: str) -> Optional[Report]:
        return run(line, cell, ipython.user_ns)

    ipython.register_magic_function(rederive, "cell", "rederive")
