"""``%load_ext rederive``: a cell that begins with ``%%rederive`` holds the text of a derivation, and shows its report.

    %%rederive NAME --claim ID --trajectory ID --sampled

The report is kept as NAME, ``report`` unless given.
"""

from __future__ import annotations

import argparse
from typing import Any, Optional

from .errors import DerivationError
from .report import Report
from .session import Session

__all__ = ["load_ipython_extension"]


class _Shown(DerivationError):
    """Problems of a cell, as a notebook shows them: no trace of calls."""

    def _render_traceback_(self) -> list[str]:
        return [str(self)]


def _arguments(line: str) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="%%rederive", add_help=False, exit_on_error=False)
    parser.add_argument("name", nargs="?", default="report")
    parser.add_argument("--claim", action="append", default=[])
    parser.add_argument("--trajectory", action="append", default=[])
    parser.add_argument("--sampled", action="store_true")
    parser.add_argument("--deadline", type=float)
    return parser.parse_args(line.split())


def run(line: str, cell: str, namespace: dict[str, Any]) -> Optional[Report]:
    """Checks the text of a cell."""
    asked = _arguments(line)
    try:
        report = Session(cell + "\n", name=f"{asked.name}.toml").check(
            asked.claim, asked.trajectory, "sampled" if asked.sampled else "enclosed", deadline=asked.deadline
        )
    except DerivationError as e:
        raise _Shown(e.problems) from None
    namespace[asked.name] = report
    return report


def load_ipython_extension(ipython: Any) -> None:
    """Makes the magic known; Python calls this for ``%load_ext rederive``."""

    def rederive(line: str, cell: str) -> Optional[Report]:
        return run(line, cell, ipython.user_ns)

    ipython.register_magic_function(rederive, "cell", "rederive")
