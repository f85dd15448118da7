"""Residuals of five equations of the Comment, and the rate of one, at many points: NumPy by SymPy's `lambdify`, heyoka's `cfunc`.

    python benches/peers/residuals.py [CARGO]

A point is R33 R31 R32 R13 R23, their rates, and 2E; out come the residuals of t9 (three), t10, t11 squared, and the rate of t10's
right side, as in `benches/number.rs`. With CARGO (`cargo`), that bench is run, too: rows `residuals_on_tape`.
"""

import os
import subprocess
import sys

import numpy as np
import sympy as sp

from clock import call

SIZES = (1_000, 100_000, 1_000_000)
INERTIA, M3 = (1.748, 1.638, 0.121), 0.75
ENTRIES = sp.symbols("R33 R31 R32 R13 R23 D33 D31 D32 D13 D23 E2", real=True)


def residuals():
    """The six formulas in the eleven numbers of a point."""
    r33, r31, r32, r13, r23, *rates, e2 = ENTRIES
    entries = (r33, r31, r32, r13, r23)
    i1, i2, i3 = (1 / sp.Float(i) for i in INERTIA)
    i12, i13 = i1 - i2, i1 - i3
    theta, psi, phi = sp.atan2(sp.sqrt(r31**2 + r32**2), r33), sp.atan2(r31, r32), sp.atan2(r13, -r23)

    def rate(e):
        return sum(sp.diff(e, x) * d for x, d in zip(entries, rates))

    st, ct, s, c = sp.sin(theta), sp.cos(theta), sp.sin(psi), sp.cos(psi)
    turning = M3 * i1 * s**2 + M3 * i2 * c**2
    under, below = i13 - i12 * c**2, i1 - i12 * c**2
    energy = (i13 - i12 * c**2) * st**2 * M3**2 + M3**2 * i3
    return [
        rate(theta) - M3 * i12 * st * s * c,
        rate(phi) - turning,
        rate(psi) - (M3 * i3 * ct - turning * ct),
        e2 - energy,
        (rate(psi) / rate(phi)) ** 2 - under * (i3 - e2 / M3**2 + under) / below**2,
        rate(energy),
    ]


def told(name, rate):
    cells = "".join(f"{1e-6 * r:10.2f}" if r else f"{'-':>10}" for r in rate)
    print(f"  {name:44}{cells}")


def main():
    formulas = residuals()
    draws = np.random.default_rng(1)
    points = {n: np.vstack([draws.uniform(-1, 1, (10, n)), draws.uniform(3, 4, (1, n))]) for n in SIZES}
    print("10^6 points a second of one core, at N =" + "".join(f"{n:>10}" for n in SIZES))
    compiled = sp.lambdify(ENTRIES, formulas, "numpy", cse=True)

    def rates_of(work):
        return [n / call(lambda n=n: work(points[n]), 3) for n in SIZES]

    told("SymPy lambdify and NumPy", rates_of(lambda p: compiled(*p)))
    try:
        import heyoka as hy
    except ImportError:
        print("  heyoka is not at hand")
    else:
        variables = hy.make_vars(*(str(s) for s in ENTRIES))
        # Angles are given to heyoka as formulas of its own: it has no converter for atan2 of SymPy's derivatives.
        for name, fast in (("heyoka cfunc", False), ("heyoka cfunc, fast_math", True)):
            function = hy.cfunc([hy.from_sympy(f) for f in formulas], vars=variables, fast_math=fast)
            out = {n: np.empty((6, n)) for n in SIZES}
            told(name, rates_of(lambda p, f=function, o=out: f(p, outputs=o[p.shape[1]])))
    if len(sys.argv) > 1:
        # One processor for both: divan takes the time of the clock.
        command = [sys.argv[1], "bench", "--bench", "number", "--", "residuals"]
        found = subprocess.run(command, capture_output=True, text=True, check=False, env={**os.environ, "NO_COLOR": "1"})
        print(found.stdout)


if __name__ == "__main__":
    main()
