"""How far something is: a line on a terminal, a bar in a notebook, nothing elsewhere."""

from __future__ import annotations

import sys
import time
import warnings
from contextlib import contextmanager
from importlib import import_module
from typing import Any, Callable, Iterator, Optional, Union

Progress = Union[None, bool, Callable[[int, int], object]]
"""``None``: on a terminal and in a notebook; otherwise whether, or a function of (done, of)."""

PATIENCE = 0.4
"""Seconds before something is shown."""
WIDTH = 30


def in_notebook() -> bool:
    """Whether a kernel runs this."""
    ipython: Any = sys.modules.get("IPython")
    return ipython is not None and getattr(ipython.get_ipython(), "kernel", None) is not None


def _bar() -> Optional[Any]:
    """The bar of tqdm that suits the place, where tqdm is installed."""
    try:
        with warnings.catch_warnings():
            # Without widgets it is a bar of letters, which will do.
            warnings.simplefilter("ignore")
            # It has no types, and need not be installed where this package is looked at.
            return import_module("tqdm.auto").tqdm
    except ImportError:
        return None


@contextmanager
def shown(progress: Progress, name: str, what: str = "motions") -> Iterator[Optional[Callable[[int, int], object]]]:
    """What is to be told how far it is: ``name`` is what is worked at, ``what`` is counted."""
    notebook = in_notebook()
    if callable(progress):
        yield progress
    elif progress is False or (progress is None and not notebook and not sys.stderr.isatty()):
        yield None
    else:
        patience = PATIENCE if progress is None else 0.0
        bar = _bar() if notebook else None
        with _line(name, what, patience) if bar is None else _told(bar, name, what, patience) as tell:
            yield tell


@contextmanager
def _told(bar: Any, name: str, what: str, patience: float) -> Iterator[Callable[[int, int], object]]:
    """A bar of tqdm, which is taken away in the end."""
    with bar(desc=name, unit=f" {what}", delay=patience, leave=False) as shown_bar:

        def tell(done: int, of: int) -> None:
            shown_bar.total = of
            shown_bar.update(done - shown_bar.n)

        yield tell


@contextmanager
def _line(name: str, what: str, patience: float) -> Iterator[Callable[[int, int], object]]:
    """A line on standard error, which is wiped in the end."""
    begun, written = time.monotonic(), False

    def tell(done: int, of: int) -> None:
        nonlocal written
        if time.monotonic() - begun < patience:
            return
        bar = "#" * (WIDTH * done // max(of, 1))
        sys.stderr.write(f"\r{name}: [{bar:<{WIDTH}}] {done}/{of} {what}")
        sys.stderr.flush()
        written = True

    try:
        yield tell
    finally:
        if written:
            sys.stderr.write("\r\x1b[K")
            sys.stderr.flush()
