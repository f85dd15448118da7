"""The command ``rederive``, as the program itself."""

from __future__ import annotations

import signal
import sys

from ._rederive import command


def main() -> int:
    # The command ends at once, as a program does, and not at the next tick of an interpreter.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    return command(["rederive", *sys.argv[1:]])


if __name__ == "__main__":
    sys.exit(main())
