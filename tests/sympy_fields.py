"""Which solutions of partial differential equations are told from ones that are subtly wrong, beside SymPy's `checkpdesol`?

In: the compiled program, and SymPy. A development tool, run by hand:

    python tests/sympy_fields.py target/release/rederive

Each row is an equation of a textbook with a solution of it, and the same with one thing changed that makes it wrong. `rederive
prove` is asked with the solution as a field that is given by a formula, a process of its own whose start counts; `checkpdesol`
with the same, at most 60 s each. Out: how many each decides, rightly and wrongly; processor seconds, sum, median and ratio.
"""

import resource
import signal
import statistics
import subprocess
import sys
import time

import sympy as sp
from sympy import cos, cot, exp, log, sech, sin, sqrt, tan, tanh, atan
from sympy.solvers.pde import checkpdesol

x, y, z, t, r, q = sp.symbols("x y z t r q", real=True)
a, b, c, k, m, n = sp.symbols("a b c k m n", positive=True)
D = sp.Derivative


def d(u, *by):
    return D(u, *by)


def laplace(u, *by):
    return sum(d(u, s, 2) for s in by)


R = sqrt(x**2 + y**2 + z**2)
# Coordinates, equation = 0, a solution, and one that is none.
ROWS = [
    ((x, t), lambda u: d(u, t) + c * d(u, x), sin(x - c * t), sin(x + c * t)),
    ((x, t), lambda u: d(u, t, 2) - c**2 * d(u, x, 2), sin(k * x) * cos(k * c * t), sin(k * x) * cos(k * t)),
    ((x, t), lambda u: d(u, t) - k * d(u, x, 2), exp(-k * a**2 * t) * sin(a * x), exp(-(a**2) * t) * sin(a * x)),
    ((x, t), lambda u: d(u, t) - k * d(u, x, 2), exp(-(x**2) / (4 * k * t)) / sqrt(t), exp(-(x**2) / (4 * k * t)) / t),
    ((x, y), lambda u: laplace(u, x, y), x**3 - 3 * x * y**2, x**3 - x * y**2),
    ((x, y), lambda u: laplace(u, x, y), log(x**2 + y**2), sqrt(x**2 + y**2)),
    ((x, y, z), lambda u: laplace(u, x, y, z), 1 / R, 1 / R**2),
    ((x, y), lambda u: laplace(u, x, y), exp(a * x) * sin(a * y), exp(a * x) * sin(y)),
    ((x, t), lambda u: d(u, t) + u * d(u, x) - k * d(u, x, 2), c - a * tanh(a * (x - c * t) / (2 * k)), c - a * tanh(a * (x - c * t) / k)),
    ((x, t), lambda u: d(u, t) + u * d(u, x), x / t, x / t**2),
    ((x, t), lambda u: d(u, t) + 6 * u * d(u, x) + d(u, x, 3), c / 2 * sech(sqrt(c) / 2 * (x - c * t)) ** 2, c * sech(sqrt(c) / 2 * (x - c * t)) ** 2),
    ((x, t), lambda u: d(u, t, 2) - c**2 * d(u, x, 2) + m**2 * u, cos(k * x - sqrt(c**2 * k**2 + m**2) * t), cos(k * x - sqrt(k**2 + m**2) * t)),
    ((x, t), lambda u: d(u, t, 2) + 2 * a * d(u, t) + a**2 * u - c**2 * d(u, x, 2), exp(-a * t) * sin(x - c * t), exp(-2 * a * t) * sin(x - c * t)),
    ((x, t), lambda u: d(u, t, 2) + b**2 * d(u, x, 4), sin(k * x) * cos(b * k**2 * t), sin(k * x) * cos(b * k * t)),
    ((x, y), lambda u: d(u, x, 4) + 2 * d(u, x, 2, y, 2) + d(u, y, 4), (x**2 + y**2) * log(x**2 + y**2), (x**2 + y**2) ** 2 * log(x**2 + y**2)),
    ((x, y, z), lambda u: laplace(u, x, y, z) + k**2 * u, sin(k * R) / R, sin(k * R) / R**2),
    ((x, t), lambda u: d(u, t) + b * d(u, x) - k * d(u, x, 2), exp(a * (x - b * t) + k * a**2 * t), exp(a * (x - b * t) + k * a * t)),
    ((x, t), lambda u: d(u, t) - d(u, x, 2) - u * (1 - u), (1 + exp((x - 5 * t / sqrt(6)) / sqrt(6))) ** -2, (1 + exp((x - 4 * t / sqrt(6)) / sqrt(6))) ** -2),
    ((x, t), lambda u: d(u, t, 2) - d(u, x, 2) + sin(u), 4 * atan(exp((x - t / 2) / sqrt(1 - sp.Rational(1, 4)))), 4 * atan(exp(x - t / 2))),
    ((x, y), lambda u: d(u, x) ** 2 + d(u, y) ** 2 - 1, sqrt(x**2 + y**2), x**2 + y**2),
    ((x, t), lambda u: d(u, t) + d(u, x) ** 2 / 2, x**2 / (2 * t), x**2 / t),
    ((x, t), lambda u: d(u, t) + d(u, x) ** 2 / 2 + x**2 / 2, x**2 / 2 * cot(t), x**2 / 2 * tan(t)),
    ((x, t), lambda u: d(u, t) - d(u**2, x, 2), t ** sp.Rational(-1, 3) * (a - x**2 / (12 * t ** sp.Rational(2, 3))), t ** sp.Rational(-1, 3) * (a - x**2 / (6 * t ** sp.Rational(2, 3)))),
    ((x, y), lambda u: x * d(u, x) + y * d(u, y) - 3 * u, x**2 * y, x * y),
    ((x, y), lambda u: d(u, x, y), sin(x) + y**2, sin(x) * y**2),
    ((x, y), lambda u: y * d(u, x, 2) + d(u, y, 2), x**2 - y**3 / 3, x**2 + y**3 / 3),
    ((x, t), lambda u: d(u, t) + a**2 * x**2 * d(u, x, 2) / 2 + b * x * d(u, x) - b * u, exp(b * t), exp(-b * t)),
    ((x, y), lambda u: laplace(u, x, y) - 4, x**2 + y**2, x**2 + 2 * y**2),
    ((x, y, t), lambda u: d(u, t) - k * laplace(u, x, y), exp(-k * (a**2 + b**2) * t) * sin(a * x) * sin(b * y), exp(-k * a * b * t) * sin(a * x) * sin(b * y)),
    ((x, t), lambda u: d(u, t) + d(u, x, 3), cos(k * x + k**3 * t), cos(k * x - k**3 * t)),
    ((x, t), lambda u: d(u, t) + d(u, x) + u * d(u, x) - d(u, x, 2, t), 3 * (c - 1) * sech(sqrt((c - 1) / c) / 2 * (x - c * t)) ** 2, 2 * (c - 1) * sech(sqrt((c - 1) / c) / 2 * (x - c * t)) ** 2),
    ((x, t), lambda u: d(u, t) + 6 * u**2 * d(u, x) + d(u, x, 3), sqrt(c) * sech(sqrt(c) * (x - c * t)), c * sech(sqrt(c) * (x - c * t))),
    ((x, y, z, t), lambda u: d(u, t, 2) - c**2 * laplace(u, x, y, z), sin(R - c * t) / R, sin(R - c * t)),
    ((x, t), lambda u: d(u, t, 2) + 2 * a * d(u, t) - c**2 * d(u, x, 2), exp(-a * t) * cos(sqrt(c**2 * k**2 - a**2) * t) * sin(k * x), exp(-a * t) * cos(sqrt(c**2 * k**2 + a**2) * t) * sin(k * x)),
    ((x, t), lambda u: d(u, t) - u - x * d(u, x) - d(u, x, 2), exp(-(x**2) / 2), exp(-(x**2))),
    ((x, t), lambda u: d(u, t) + b * d(u, x) - k * d(u, x, 2), exp(-((x - b * t) ** 2) / (4 * k * t)) / sqrt(t), exp(-((x + b * t) ** 2) / (4 * k * t)) / sqrt(t)),
    ((x, t), lambda u: d(u, t) - d(u, x, 2) / 2 + x**2 * u / 2, exp(-(x**2) / 2 - t / 2), exp(-(x**2) / 2 - t)),
    ((r, q), lambda u: d(u, r, 2) + d(u, r) / r + d(u, q, 2) / r**2, r**3 * cos(3 * q), r**3 * cos(2 * q)),
    ((r, t), lambda u: d(u, t, 2) - c**2 * (d(u, r, 2) + 2 * d(u, r) / r), cos(k * (r - c * t)) / r, cos(k * (r - c * t)) / r**2),
    ((x, t), lambda u: d(u, t) - k * d(u, x, 2) + b * u, exp(-(k * a**2 + b) * t) * cos(a * x), exp(-(k * a**2 - b) * t) * cos(a * x)),
]


def asked(program, coordinates, equation, solution):
    u = sp.Function("u")(*coordinates)
    # As a person writes it: u at its own coordinates is u.
    text = sp.latex(equation(u), ln_notation=True).replace(sp.latex(u), "u")
    free = sorted(map(str, (equation(u).free_symbols | solution.free_symbols) - set(coordinates)))
    symbols = [f"{s}: coordinate" for s in coordinates] + [f"{s}: positive" for s in free]
    names = ",".join(map(str, coordinates))
    symbols.append(f"u({names}): field = {sp.latex(solution, ln_notation=True)}")
    given = [argument for s in symbols for argument in ("--symbol", s)]
    if any(s in (t, r) for s in coordinates):
        given += [argument for s in coordinates if s in (t, r) for argument in ("--given", f"{s}>0")]
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    run = subprocess.run([program, "prove", f"{text}=0", *given], capture_output=True, text=True, check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime
    lines = (run.stdout or run.stderr).splitlines() or [""]
    return lines[0], seconds, run.stderr


class Late(BaseException):
    """It took too long."""


def late(*_):
    raise Late


signal.signal(signal.SIGALRM, late)


def of_sympy(coordinates, equation, solution):
    u = sp.Function("u")(*coordinates)
    sp.core.cache.clear_cache()
    begun = time.process_time()
    signal.alarm(60)
    try:
        found = "proved" if checkpdesol(sp.Eq(equation(u).doit(), 0), sp.Eq(u, solution))[0] else "refuted"
    except Late:
        found = "late"
    except Exception as error:  # What it cannot do it says in many ways.
        found = type(error).__name__
    finally:
        signal.alarm(0)
    return found, time.process_time() - begun


def main(program):
    totals = {"rederive": [], "checkpdesol": []}
    for coordinates, equation, right, wrong in ROWS:
        for solution, wanted in ((right, "proved"), (wrong, "refuted")):
            word, seconds, said = asked(program, coordinates, equation, solution)
            totals["rederive"].append((word == wanted, word in ("proved", "refuted") and word != wanted, seconds))
            if word != wanted:
                print(f"rederive: {word} instead of {wanted}: {sp.latex(solution)}\n{said}", file=sys.stderr)
            word, seconds = of_sympy(coordinates, equation, solution)
            totals["checkpdesol"].append((word == wanted, word in ("proved", "refuted") and word != wanted, seconds))
            if word != wanted:
                print(f"checkpdesol: {word} instead of {wanted}: {sp.latex(solution)}", file=sys.stderr)
    for name, rows in totals.items():
        times = [seconds for *_, seconds in rows]
        decided, false = sum(r for r, *_ in rows), sum(w for _, w, _ in rows)
        print(f"{name}: {decided} of {len(rows)} decided rightly, {false} wrongly; {sum(times):.2f} s, median {statistics.median(times) * 1e3:.1f} ms")


main(*sys.argv[1:])
