"""Seven identities of the Comment: `prove` as a process of its own, SymPy's `simplify`, and polynomials of python-flint.

    python benches/peers/identities.py PROGRAM

They are those of the bench `identity` and of `python/identities.ipynb`. SymPy is warm; of python-flint only arithmetic is timed:
the formulas are rational functions of sines, cosines and an exponential already, and what is left is to clear denominators and to
reduce by sin² + cos² = 1. How fast `prove` is in one process, `cargo bench --bench identity` says.
"""

import subprocess
import sys

import sympy as sp

from clock import call, process

I = sp.symbols("I_1:4", positive=True)
m = sp.Symbol("m", positive=True)
c, t = sp.Symbol("c", positive=True), sp.Symbol("t", real=True)
phi, theta, psi = sp.symbols("phi theta psi", real=True)


def identities():
    """Name, left and right."""
    R = sp.rot_ccw_axis3(phi) * sp.rot_ccw_axis1(theta) * sp.rot_ccw_axis3(psi)
    omega = [m * R[2, k] / I[k] for k in range(3)]
    turning = m / I[0] * sp.sin(psi) ** 2 + m / I[1] * sp.cos(psi) ** 2
    bend = 1 / I[0] - 1 / I[1]
    rate = {theta: m * bend * sp.sin(theta) * sp.sin(psi) * sp.cos(psi), phi: turning,
            psi: -turning * sp.cos(theta) + m / I[2] * sp.cos(theta)}

    def changed(entry):
        return sum(sp.diff(entry, angle) * rate[angle] for angle in rate)

    def turned(i, j):
        k, l = (j + 1) % 3, (j + 2) % 3
        return R[i, k] * omega[l] - R[i, l] * omega[k]

    under = 1 / I[0] - 1 / I[2] - bend * sp.cos(psi) ** 2
    twice_energy = m**2 / I[2] + m**2 * under * sp.sin(theta) ** 2
    square = I[1] * (I[2] - I[0]) / (I[2] * (I[1] - I[0]))
    grown = c * sp.exp(m * bend * sp.sin(2 * psi) * t)
    cosine, sine = (1 - grown) / (1 + grown), 2 * sp.sqrt(grown) / (1 + grown)
    return [
        ("t9, theta", changed(R[2, 2]), turned(2, 2)),
        ("t9, phi", changed(R[0, 2]), turned(0, 2)),
        ("t9, psi", changed(R[2, 0]), turned(2, 0)),
        ("t10", sum(I[k] * omega[k] ** 2 for k in range(3)), twice_energy),
        ("t11 squared", (rate[psi] / rate[phi]) ** 2,
         under * (1 / I[2] - twice_energy / m**2 + under) / (1 / I[0] - bend * sp.cos(psi) ** 2) ** 2),
        ("psi_0", m / I[0] * (1 - square) + m / I[1] * square, m / I[2]),
        ("t15", -sp.diff(cosine, t) / sine, rate[theta].subs(sp.sin(theta), sine)),
    ]


class Fraction:
    """A quotient of polynomials that is never reduced."""

    def __init__(self, over, under):
        self.over, self.under = over, under

    def __add__(self, other):
        return Fraction(self.over * other.under + other.over * self.under, self.under * other.under)

    def __mul__(self, other):
        return Fraction(self.over * other.over, self.under * other.under)

    def power(self, n):
        return Fraction(self.over**n, self.under**n) if n >= 0 else Fraction(self.under**-n, self.over**-n)


def by_flint(difference):
    """What decides by polynomials whether an expression is 0; `None` where it is no rational function of its generators."""
    from flint import Ordering, fmpz_mpoly_ctx

    expanded = sp.expand_trig(difference)
    root = sp.Symbol("w", positive=True)
    exponents = [e.args[0] for e in expanded.atoms(sp.exp)]
    if exponents:
        half = min(exponents, key=sp.count_ops) / 2
        expanded = expanded.subs({sp.exp(e): root ** int(sp.simplify(e / half)) for e in exponents})
        expanded = sp.powdenest(expanded.subs(c, sp.Symbol("q", positive=True) ** 2), force=True)
    put, relations = {}, []
    for angle in (phi, theta, psi):
        pair = sp.symbols(f"s_{angle} c_{angle}")
        put.update({sp.sin(angle): pair[0], sp.cos(angle): pair[1]})
        relations.append(pair)
    rational = expanded.subs(put)
    names = sorted(str(s) for s in rational.free_symbols | {s for pair in relations for s in pair})
    names.sort(key=lambda name: not name.startswith("s_"))
    ring = fmpz_mpoly_ctx.get(names, Ordering.lex)
    generators = dict(zip(names, ring.gens()))
    one = generators[names[0]] ** 0

    def value(e):
        if e.is_Rational:
            return Fraction(one * int(e.p), one * int(e.q))
        if e.is_Symbol:
            return Fraction(generators[str(e)], one)
        if e.is_Add or e.is_Mul:
            parts = [value(a) for a in e.args]
            total = parts[0]
            for part in parts[1:]:
                total = total + part if e.is_Add else total * part
            return total
        if e.is_Pow and e.exp.is_Integer:
            return value(e.base).power(int(e.exp))
        raise ValueError(e)

    circles = [generators[str(s)] ** 2 + generators[str(k)] ** 2 - one for s, k in relations]

    def decides():
        over = value(rational).over
        for circle in circles:
            over = divmod(over, circle)[1]
        return over == 0

    try:
        return decides if decides() else None
    except ValueError:
        return None


def main():
    program = sys.argv[1]
    total = [0.0, 0.0, 0.0]
    print(f"{'':12} {'prove, cold':>14} {'simplify':>16} {'python-flint':>14}   ms of the processor")
    for name, left, right in identities():
        symbols = sorted(str(s) for s in (left - right).free_symbols)
        positive = {"I_1", "I_2", "I_3", "m", "c"}
        written = [rf"\{s}" if s in ("phi", "theta", "psi") else s for s in symbols]
        asked = [f"--symbol={w}: positive" if s in positive else f"--symbol={w}" for w, s in zip(written, symbols)]
        text = f"{sp.latex(left)}={sp.latex(right)}".replace(r"\left", "").replace(r"\right", "")
        ours = process([program, "prove", *asked, "--", text])
        proved = subprocess.run([program, "prove", *asked, "--", text], capture_output=True, check=False).returncode == 0
        zero = []
        theirs = call(lambda: zero.append(sp.simplify(left - right) == 0), 1)
        try:
            polynomials = by_flint(left - right)
        except ImportError:
            polynomials = None
        flint = call(polynomials) if polynomials else None
        cells = [ours[0] if ours else None, theirs, flint]
        total = [a + (b or 0.0) for a, b in zip(total, cells)]
        told = ["-" if x is None else f"{1e3 * x:.2f}" for x in cells]
        print(f"{name:12} {told[0]:>14} {told[1] + (' (0)' if zero[0] else ' (not 0)'):>16} {told[2]:>14}"
              + ("" if proved else "   not proved"))
    print(f"{'all':12} {1e3 * total[0]:14.2f} {1e3 * total[1]:16.2f} {1e3 * total[2]:14.2f}")


if __name__ == "__main__":
    main()
