"""Whole processes, from their start to their end: `prove`, checks, and what it takes to import a library.

    python benches/peers/processes.py PROGRAM [--comment]

`--comment` checks the largest derivation, too: some tens of seconds.
"""

import pathlib
import sys
import tempfile

from clock import process, python, row

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
COMMENT = ROOT / "derivations/deriglazov-comment.toml"
# A check ends with these where verdicts are not as expected, or open.
CHECKED = (0, 1, 3)
IMPORTS = ["sympy", "scipy.integrate", "heyoka", "flint"]


def without_families(text):
    """The Comment with its single motions alone, as it was when the aims were set."""
    kept = [part for part in ("\n" + text).split("\n[") if not part.startswith("[family]]") and "\nfamilies = [" not in part]
    return "\n[".join(kept)


def main():
    program = sys.argv[1]
    check = [program, "check", "--jobs", "1", "--no-reports", "-q"]
    print("a process, of the processor:")
    row("rederive prove sin 2x = 2 sin x cos x", process([program, "prove", r"\sin 2x=2\sin x\cos x", "--symbol", "x"]))
    row("SymPy, the same by simplify", python(
        "from sympy import *; x = symbols('x', real=True); assert simplify(sin(2*x) - 2*sin(x)*cos(x)) == 0"))
    for name in IMPORTS:
        row(f"import {name}", python(f"import {name}"))
    for name in ("pendulum", "kepler", "schwarzschild"):
        row(f"rederive check {name}", process([*check, str(ROOT / f"derivations/{name}.toml")], 3, CHECKED))
    one = ["--claim", "t9-psi", "--trajectory", "racket-out"]
    row("one claim of the Comment on one motion, enclosed", process([*check, str(COMMENT), *one], good=CHECKED))
    if "--comment" not in sys.argv:
        return
    with tempfile.TemporaryDirectory() as folder:
        single = pathlib.Path(folder) / "comment.toml"
        single.write_text(without_families(COMMENT.read_text(encoding="utf-8")), encoding="utf-8")
        for name, path in (("the Comment", COMMENT), ("the same without its families", single)):
            for words in (["--rigor", "sampled", "--only-verdicts"], ["--rigor", "sampled"], ["--only-verdicts"], []):
                row(f"{name}, {' '.join(words) or 'enclosed, all that a report has'}", process([*check, str(path), *words], 1, CHECKED))


if __name__ == "__main__":
    main()
