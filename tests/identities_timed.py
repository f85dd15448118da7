"""How long does a proof take, beside `simplify` of SymPy?

In: the compiled program, and lists of identities as `tests/reach/true.txt`. A development tool, run by hand with a Python that has
SymPy and the version of antlr4-python3-runtime that its reader of LaTeX asks for:

    python tests/identities_timed.py target/release/rederive tests/reach/true.txt

Every identity that SymPy's reader takes is given to both: to `rederive prove`, a process of its own whose start counts, and to
`simplify(left - right) == 0` with the same assumptions, in one process that has read SymPy before. Identities that follow from
other equations are left out: `simplify` has no place for these. Times are those of the processor: of `prove` the mean of many
runs, since a system counts the time of other processes in ticks, of `simplify` the least of several. Out: how many each proves, the sums, the medians, and the median of the ratios.
"""

import resource
import signal
import statistics
import subprocess
import sys
import time

import sympy
from sympy.parsing.latex import parse_latex

RUNS = 5
MANY = 20
LONGEST = 20


class Late(Exception):
    """It took too long."""


def late(*_):
    raise Late


def rows(path):
    """Symbols, what is given, and the equation of every line."""
    for line in open(path, encoding="utf-8"):
        parts = line.rstrip("\n").removeprefix("? ").split(" | ", 2)
        if not line.startswith("#") and len(parts) == 3:
            symbols, given, formula = parts
            yield [s.strip() for s in symbols.split(", ") if s.strip()], given.strip(), formula.strip()


def in_sympy(symbols, formula):
    """Left − right with the assumptions of the list; nothing where SymPy reads something else than symbols and functions."""
    equation = parse_latex(formula)
    if not isinstance(equation, sympy.Equality):
        return None
    declared = {}
    for text in symbols:
        name, _, kind = text.partition(":")
        if kind.strip() not in ("", "parameter", "positive"):
            return None
        assumptions = {"positive": True} if "positive" in kind else {"real": True}
        declared[name.strip().lstrip("\\")] = assumptions
    put = {}
    for symbol in equation.free_symbols:
        name = symbol.name.lstrip("\\")
        if name not in declared:
            return None
        put[symbol] = sympy.Symbol(name, **declared[name])
    return (equation.lhs - equation.rhs).subs(put).subs(sympy.Symbol("e"), sympy.E)


def spent():
    """Processor time of the processes that have ended."""
    of = resource.getrusage(resource.RUSAGE_CHILDREN)
    return of.ru_utime + of.ru_stime


def ours(program, symbols, formula):
    before = spent()
    for _ in range(MANY):
        found = subprocess.run([program, "prove", *(f"--symbol={s}" for s in symbols), "--format=json", "--", formula],
                               capture_output=True, check=False)
    return (spent() - before) / MANY, found.returncode == 0


def theirs(difference):
    best, proved = None, False
    for _ in range(RUNS):
        sympy.core.cache.clear_cache()
        before = time.process_time()
        signal.alarm(LONGEST)
        try:
            proved = sympy.simplify(difference) == 0
        except Late:
            return float(LONGEST), False
        except Exception:  # noqa: BLE001: whatever goes wrong there is no proof
            proved = False
        finally:
            signal.alarm(0)
        took = time.process_time() - before
        best = took if best is None else min(best, took)
    return best, proved


def main(program, paths):
    signal.signal(signal.SIGALRM, late)
    left_out, times, proofs = 0, [], [0, 0]
    for path in paths:
        for symbols, given, formula in rows(path):
            try:
                difference = None if given else in_sympy(symbols, formula)
            except Exception:  # noqa: BLE001: its reader has many ways to refuse
                difference = None
            if difference is None:
                left_out += 1
                continue
            (a, ours_proves), (b, theirs_proves) = ours(program, symbols, formula), theirs(difference)
            times.append((a, b))
            proofs[0] += ours_proves
            proofs[1] += theirs_proves
    both = list(zip(*times))
    print(f"{len(times)} identities, {left_out} left out")
    print(f"proved: rederive {proofs[0]}, simplify {proofs[1]}")
    for name, of in zip(("rederive", "simplify"), both):
        print(f"{name}: sum {sum(of):.2f} s, median {1e3 * statistics.median(of):.1f} ms, longest {1e3 * max(of):.0f} ms")
    ratios = [b / a for a, b in times if a > 0]
    print(f"median of the ratios simplify/rederive: {statistics.median(ratios):.1f}")


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2:])
