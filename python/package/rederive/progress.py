"""How far a check is: a line on a terminal, nothing elsewhere."""

from __future__ import annotations

import sys
import time
from contextlib import contextmanager
from typing import Callable, Iterator, Optional, Union

Progress = Union[None, bool, Callable[[int, int], object]]
"""``None``: where standard error is a terminal; otherwise whether, or a function of (done, of)."""

PATIENCE = 0.4
"""Seconds before a line is shown."""
WIDTH = 30


@contextmanager
def shown(progress: Progress, name: str) -> Iterator[Optional[Callable[[int, int], object]]]:
    """What is to be told how far it is."""
    if callable(progress):
        yield progress
        return
    if progress is False or (progress is None and not sys.stderr.isatty()):
        yield None
        return
    begun, written = time.monotonic(), False

    def tell(done: int, of: int) -> None:
        nonlocal written
        if progress is None and time.monotonic() - begun < PATIENCE:
            return
        bar = "#" * (WIDTH * done // max(of, 1))
        sys.stderr.write(f"\r{name}: [{bar:<{WIDTH}}] {done}/{of} motions")
        sys.stderr.flush()
        written = True

    try:
        yield tell
    finally:
        if written:
            sys.stderr.write("\r\x1b[K")
            sys.stderr.flush()
