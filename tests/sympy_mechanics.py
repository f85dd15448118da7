"""Which statements of mechanics and vector calculus are told from ones that are subtly wrong, beside SymPy?

In: the compiled program, and SymPy. A development tool, run by hand:

    python tests/sympy_mechanics.py target/release/rederive

Twenty densities with their equation of Euler and Lagrange, beside `sympy.calculus.euler.euler_equations`; twenty formulas of vector
calculus, beside `sympy.vector`; each once more with one thing changed that makes it wrong. `rederive prove` is asked in a process
of its own whose start counts; SymPy has 60 s for each. Out: how many each decides, rightly and wrongly; processor seconds, sum,
median and ratio.
"""

import resource
import signal
import statistics
import subprocess
import sys
import time

import sympy as sp
from sympy.calculus.euler import euler_equations
from sympy.vector import CoordSys3D, curl, directional_derivative, divergence, gradient, laplacian

t, x, y = sp.symbols("t x y", real=True)
a, b, c, g, k, m, n = sp.symbols("a b c g k m n", positive=True)
cos, sin, sqrt, exp, ln = sp.cos, sp.sin, sp.sqrt, sp.exp, sp.log

q, s = (sp.Function(name)(t) for name in "qs")
u = sp.Function("u")(x, t)
v = sp.Function("v")(x, t)
w = sp.Function("w")(x, y)
h = sp.Function("h")(x)


def d(of, *by):
    return sp.diff(of, *by)


# The density, what is varied, and the variational derivative: rightly and wrongly. For SymPy the sign and a factor matter as well.
DENSITIES = [
    (m / 2 * d(q, t) ** 2, q, -m * d(q, t, 2), -m / 2 * d(q, t, 2)),
    (m / 2 * d(q, t) ** 2 - k / 2 * q**2, q, -m * d(q, t, 2) - k * q, -m * d(q, t, 2) + k * q),
    (m / 2 * a**2 * d(q, t) ** 2 + m * g * a * cos(q), q, -m * a**2 * d(q, t, 2) - m * g * a * sin(q), -m * a**2 * d(q, t, 2) - m * g * sin(q)),
    (m / 2 * (d(q, t) ** 2 + q**2 * d(s, t) ** 2) + k / q, q, -m * d(q, t, 2) + m * q * d(s, t) ** 2 - k / q**2, -m * d(q, t, 2) + m * q * d(s, t) ** 2 + k / q**2),
    (m / 2 * (d(q, t) ** 2 + q**2 * d(s, t) ** 2) + k / q, s, -m * q**2 * d(s, t, 2) - 2 * m * q * d(q, t) * d(s, t), -m * q**2 * d(s, t, 2) - m * q * d(q, t) * d(s, t)),
    (m / 2 * (d(q, t) ** 2 + d(s, t) ** 2) + b / 2 * (q * d(s, t) - s * d(q, t)), q, -m * d(q, t, 2) + b * d(s, t), -m * d(q, t, 2) + b / 2 * d(s, t)),
    (-m * sqrt(1 - d(q, t) ** 2), q, -m * d(q, t, 2) / (1 - d(q, t) ** 2) ** sp.Rational(3, 2), -m * d(q, t, 2) / sqrt(1 - d(q, t) ** 2)),
    (exp(b * t) * (m / 2 * d(q, t) ** 2 - k / 2 * q**2), q, -exp(b * t) * (m * d(q, t, 2) + m * b * d(q, t) + k * q), -exp(b * t) * (m * d(q, t, 2) + b * d(q, t) + k * q)),
    (d(q, t) ** 2 / 2 + sin(q) ** 2 * d(s, t) ** 2 / 2, q, -d(q, t, 2) + sin(q) * cos(q) * d(s, t) ** 2, -d(q, t, 2) + sin(q) ** 2 * d(s, t) ** 2),
    (-(d(q, t, 2) ** 2) / 2 + a**2 * d(q, t) ** 2 / 2 - b**2 * q**2 / 2, q, -d(q, t, 4) - a**2 * d(q, t, 2) - b**2 * q, d(q, t, 4) - a**2 * d(q, t, 2) - b**2 * q),
    (m / 2 * (d(q, t) ** 2 + d(s, t) ** 2 + cos(q - s) * d(q, t) * d(s, t)), q, -m * d(q, t, 2) - m / 2 * (cos(q - s) * d(s, t, 2) + sin(q - s) * d(s, t) ** 2), -m * d(q, t, 2) - m / 2 * (cos(q - s) * d(s, t, 2) - sin(q - s) * d(s, t) ** 2)),
    (sqrt((1 + d(h, x) ** 2) / h), h, -(2 * h * d(h, x, 2) + 1 + d(h, x) ** 2) / (2 * h ** sp.Rational(3, 2) * (1 + d(h, x) ** 2) ** sp.Rational(3, 2)), -(h * d(h, x, 2) + 1 + d(h, x) ** 2) / (2 * h ** sp.Rational(3, 2) * (1 + d(h, x) ** 2) ** sp.Rational(3, 2))),
    (d(u, t) ** 2 / 2 - c**2 / 2 * d(u, x) ** 2, u, -d(u, t, 2) + c**2 * d(u, x, 2), -d(u, t, 2) - c**2 * d(u, x, 2)),
    (d(u, t) ** 2 / 2 - d(u, x) ** 2 / 2 - m**2 / 2 * u**2 - g / 4 * u**4, u, -d(u, t, 2) + d(u, x, 2) - m**2 * u - g * u**3, -d(u, t, 2) + d(u, x, 2) - m**2 * u - g / 4 * u**3),
    (d(u, t) ** 2 / 2 - d(u, x) ** 2 / 2 - 1 + cos(u), u, -d(u, t, 2) + d(u, x, 2) - sin(u), -d(u, t, 2) + d(u, x, 2) + sin(u)),
    (d(u, t) ** 2 / 2 - b / 2 * d(u, x, 2) ** 2, u, -d(u, t, 2) - b * d(u, x, 4), -d(u, t, 2) + b * d(u, x, 4)),
    (d(u, x) * d(u, t) / 2 + d(u, x) ** 3 - d(u, x, 2) ** 2 / 2, u, -d(u, x, t) - 6 * d(u, x) * d(u, x, 2) - d(u, x, 4), -d(u, x, t) - 3 * d(u, x) * d(u, x, 2) - d(u, x, 4)),
    (sqrt(1 + d(w, x) ** 2 + d(w, y) ** 2), w, -((1 + d(w, y) ** 2) * d(w, x, 2) - 2 * d(w, x) * d(w, y) * d(w, x, y) + (1 + d(w, x) ** 2) * d(w, y, 2)) / (1 + d(w, x) ** 2 + d(w, y) ** 2) ** sp.Rational(3, 2), -((1 + d(w, y) ** 2) * d(w, x, 2) - d(w, x) * d(w, y) * d(w, x, y) + (1 + d(w, x) ** 2) * d(w, y, 2)) / (1 + d(w, x) ** 2 + d(w, y) ** 2) ** sp.Rational(3, 2)),
    ((d(u, t) ** 2 + d(v, t) ** 2 - d(u, x) ** 2 - d(v, x) ** 2) / 2 - g / 2 * u**2 * v**2, u, -d(u, t, 2) + d(u, x, 2) - g * u * v**2, -d(u, t, 2) + d(u, x, 2) - g * u**2 * v),
    (sqrt(1 - d(u, t) ** 2 + d(u, x) ** 2), u, ((1 + d(u, x) ** 2) * d(u, t, 2) - 2 * d(u, x) * d(u, t) * d(u, x, t) - (1 - d(u, t) ** 2) * d(u, x, 2)) / (1 - d(u, t) ** 2 + d(u, x) ** 2) ** sp.Rational(3, 2), ((1 - d(u, x) ** 2) * d(u, t, 2) - 2 * d(u, x) * d(u, t) * d(u, x, t) - (1 - d(u, t) ** 2) * d(u, x, 2)) / (1 - d(u, t) ** 2 + d(u, x) ** 2) ** sp.Rational(3, 2)),
]

N = CoordSys3D("N")
S = CoordSys3D("S", transformation="spherical", variable_names=("r", "p", "q"))
C = CoordSys3D("C", transformation="cylindrical", variable_names=("r", "p", "z"))
X = (N.x, N.y, N.z)
F, G = (sp.Function(name)(*X) for name in "fg")
A, B = (sum((sp.Function(f"{name}{i}")(*X) * e for i, e in enumerate((N.i, N.j, N.k))), sp.vector.Vector.zero) for name in "AB")
R = N.x * N.i + N.y * N.j + N.z * N.k
r = sqrt(N.x**2 + N.y**2 + N.z**2)
W = a * N.i + b * N.j + c * N.k
f_r, A_r = sp.Function("f")(S.r), sp.Function("A")(S.r)
A_c, f_c = sp.Function("A")(C.r), sp.Function("f")(C.r)

CARTESIAN = [r"f(x,y,z), g(x,y,z): field", r"{\bf A}(x,y,z), {\bf B}(x,y,z): field, 3"]
PLACE = [r"{\bf r}: coordinate, 3", r"r = |{\bf r}|", r"{\bf w}: 3"]
ROUND = ["r: coordinate", r"\theta: coordinate = r", r"\varphi: coordinate = r\sin\theta", "f(r): field", r"A(r): field", r"{\bf A}(r): field, 3 = (A,0,0)"]
TUBE = ["r: coordinate", r"\varphi: coordinate = r", "z: coordinate", "f(r): field", "A(r): field", r"{\bf A}(r): field, 3 = (A,0,0)"]

# Symbols, left, right, wrong; the same for SymPy.
FORMULAS = [
    (CARTESIAN, r"\nabla\times\nabla f", "0", r"\nabla f", curl(gradient(F)), 0 * N.i, gradient(F)),
    (CARTESIAN, r"\nabla\cdot(\nabla\times{\bf A})", "0", r"\nabla\cdot{\bf A}", divergence(curl(A)), 0, divergence(A)),
    (CARTESIAN, r"\nabla(fg)", r"f\nabla g+g\nabla f", r"f\nabla g-g\nabla f", gradient(F * G), F * gradient(G) + G * gradient(F), F * gradient(G) - G * gradient(F)),
    (CARTESIAN, r"\nabla\cdot(f{\bf A})", r"f\nabla\cdot{\bf A}+{\bf A}\cdot\nabla f", r"f\nabla\cdot{\bf A}", divergence(F * A), F * divergence(A) + A.dot(gradient(F)), F * divergence(A)),
    (CARTESIAN, r"\nabla\times(f{\bf A})", r"f\nabla\times{\bf A}+(\nabla f)\times{\bf A}", r"f\nabla\times{\bf A}+{\bf A}\times\nabla f", curl(F * A), F * curl(A) + gradient(F).cross(A), F * curl(A) + A.cross(gradient(F))),
    (CARTESIAN, r"\nabla\cdot({\bf A}\times{\bf B})", r"{\bf B}\cdot(\nabla\times{\bf A})-{\bf A}\cdot(\nabla\times{\bf B})", r"{\bf B}\cdot(\nabla\times{\bf A})+{\bf A}\cdot(\nabla\times{\bf B})", divergence(A.cross(B)), B.dot(curl(A)) - A.dot(curl(B)), B.dot(curl(A)) + A.dot(curl(B))),
    (CARTESIAN, r"\nabla^2(fg)", r"f\nabla^2g+2(\nabla f)\cdot(\nabla g)+g\nabla^2f", r"f\nabla^2g+(\nabla f)\cdot(\nabla g)+g\nabla^2f", laplacian(F * G), F * laplacian(G) + 2 * gradient(F).dot(gradient(G)) + G * laplacian(F), F * laplacian(G) + gradient(F).dot(gradient(G)) + G * laplacian(F)),
    (CARTESIAN, r"\nabla\times(\nabla\times{\bf A})", r"\nabla(\nabla\cdot{\bf A})-\nabla^2{\bf A}", r"\nabla(\nabla\cdot{\bf A})+\nabla^2{\bf A}", curl(curl(A)), gradient(divergence(A)) - laplacian(A), gradient(divergence(A)) + laplacian(A)),
    (CARTESIAN, r"\nabla\cdot(f\nabla g-g\nabla f)", r"f\nabla^2g-g\nabla^2f", r"f\nabla^2g+g\nabla^2f", divergence(F * gradient(G) - G * gradient(F)), F * laplacian(G) - G * laplacian(F), F * laplacian(G) + G * laplacian(F)),
    (CARTESIAN, r"\nabla\times(f\nabla g)", r"(\nabla f)\times(\nabla g)", r"(\nabla g)\times(\nabla f)", curl(F * gradient(G)), gradient(F).cross(gradient(G)), gradient(G).cross(gradient(F))),
    (CARTESIAN, r"\nabla\cdot((\nabla f)\times(\nabla g))", "0", r"(\nabla f)\cdot(\nabla g)", divergence(gradient(F).cross(gradient(G))), 0, gradient(F).dot(gradient(G))),
    (CARTESIAN, r"({\bf A}\cdot\nabla){\bf A}", r"\nabla(\frac12{\bf A}^2)-{\bf A}\times(\nabla\times{\bf A})", r"\nabla({\bf A}^2)-{\bf A}\times(\nabla\times{\bf A})", directional_derivative(A, A), gradient(A.dot(A) / 2) - A.cross(curl(A)), gradient(A.dot(A)) - A.cross(curl(A))),
    (PLACE, r"\nabla\frac1r", r"-\frac{{\bf r}}{r^3}", r"-\frac{{\bf r}}{r^2}", gradient(1 / r), -R / r**3, -R / r**2),
    (PLACE, r"\nabla^2\frac1r", "0", r"\frac1{r^3}", laplacian(1 / r), 0, 1 / r**3),
    (PLACE, r"\nabla\times({\bf w}\times{\bf r})", r"2{\bf w}", r"{\bf w}", curl(W.cross(R)), 2 * W, W),
    (PLACE, r"\nabla\cdot(r^2{\bf r})", "5r^2", "4r^2", divergence(r**2 * R), 5 * r**2, 4 * r**2),
    (PLACE, r"\nabla^2e^{{\bf w}\cdot{\bf r}}", r"{\bf w}^2e^{{\bf w}\cdot{\bf r}}", r"|{\bf w}|e^{{\bf w}\cdot{\bf r}}", laplacian(exp(W.dot(R))), W.dot(W) * exp(W.dot(R)), sqrt(W.dot(W)) * exp(W.dot(R))),
    (ROUND, r"\nabla^2f", r"f''+\frac{2f'}{r}", r"f''+\frac{f'}{r}", laplacian(f_r), f_r.diff(S.r, 2) + 2 * f_r.diff(S.r) / S.r, f_r.diff(S.r, 2) + f_r.diff(S.r) / S.r),
    (ROUND, r"\nabla\cdot{\bf A}", r"A'+\frac{2A}{r}", r"A'+\frac{A}{r}", divergence(A_r * S.i), A_r.diff(S.r) + 2 * A_r / S.r, A_r.diff(S.r) + A_r / S.r),
    (TUBE, r"\nabla\cdot(f\nabla f)", r"ff''+f'^2+\frac{ff'}{r}", r"ff''+f'^2+\frac{2ff'}{r}", divergence(f_c * gradient(f_c)), f_c * f_c.diff(C.r, 2) + f_c.diff(C.r) ** 2 + f_c * f_c.diff(C.r) / C.r, f_c * f_c.diff(C.r, 2) + f_c.diff(C.r) ** 2 + 2 * f_c * f_c.diff(C.r) / C.r),
]


def printed(e):
    """As a person writes it: dots for rates, subscripts for derivatives of fields."""

    def derivative(found):
        name = found.expr.func.__name__
        by = "".join(str(v) * int(count) for v, count in found.variable_count)
        if found.expr.args != (t,):
            return sp.Symbol(f"{name}_{{{by}}}")
        return sp.Symbol(rf"\{'d' * len(by)}ot{{{name}}}")

    e = e.replace(lambda f: isinstance(f, sp.Derivative), derivative)
    for f in (q, s, u, v, w, h):
        e = e.subs(f, sp.Symbol(f.func.__name__))
    return sp.latex(e, ln_notation=True, mul_symbol="dot")


def asked(program, formula, symbols):
    command = [program, "prove", formula, *(argument for symbol in symbols for argument in ("--symbol", symbol))]
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime
    return (run.stdout or run.stderr).splitlines()[0], seconds, run.stderr


class Late(BaseException):
    """It took too long."""


def late(*_):
    raise Late


signal.signal(signal.SIGALRM, late)


def of_sympy(difference):
    """What SymPy says of what should be 0."""
    sp.core.cache.clear_cache()
    begun = time.process_time()
    signal.alarm(60)
    try:
        left = difference()
        if isinstance(left, sp.vector.Vector):
            parts = list(left.doit().components.values())
        else:
            parts = [sp.sympify(left).doit()]
        found = "proved" if all(sp.simplify(part) == 0 for part in parts) else "refuted"
    except Late:
        found = "late"
    except Exception as error:  # What it cannot do it says in many ways.
        found = type(error).__name__
    finally:
        signal.alarm(0)
    return found, time.process_time() - begun


def varied(density, of, said):
    equation = euler_equations(density, of, list(of.args))[0]
    return equation.lhs - said


def main(program):
    totals = {name: [] for name in ("rederive, δ", "euler_equations", "rederive, ∇", "vector")}

    def count(who, wanted, word, seconds, what):
        totals[who].append((word == wanted, word in ("proved", "refuted") and word != wanted, seconds))
        if word != wanted:
            print(f"{who}: {word} instead of {wanted}: {what}", file=sys.stderr)

    for density, of, right, wrong in DENSITIES:
        name = of.func.__name__
        moves = of.args == (t,)
        names = "q, s: state" if moves else "h(x), u(x,t), v(x,t), w(x,y): field"
        free = sorted(map(str, (density.free_symbols | right.free_symbols) - {t, x, y}))
        symbols = ["t: time", names, *(f"{p}: positive" for p in free), f"L = {printed(density)}"]
        for said, wanted in ((right, "proved"), (wrong, "refuted")):
            word, seconds, error = asked(program, rf"\frac{{\delta L}}{{\delta {name}}}={printed(said)}", symbols)
            count("rederive, δ", wanted, word, seconds, f"{said}\n{error}")
            word, seconds = of_sympy(lambda said=said: varied(density, of, said))
            count("euler_equations", wanted, word, seconds, said)
    for symbols, left, right, wrong, of, is_right, is_wrong in FORMULAS:
        for text, said, wanted in ((right, is_right, "proved"), (wrong, is_wrong, "refuted")):
            word, seconds, error = asked(program, f"{left}={text}", symbols)
            count("rederive, ∇", wanted, word, seconds, f"{left}={text}\n{error}")
            word, seconds = of_sympy(lambda said=said: of - said)
            count("vector", wanted, word, seconds, f"{left}={text}")
    for name, rows in totals.items():
        times = [seconds for *_, seconds in rows]
        decided, false = sum(r for r, *_ in rows), sum(w for _, w, _ in rows)
        print(f"{name}: {decided} of {len(rows)} decided rightly, {false} wrongly; {sum(times):.2f} s, median {statistics.median(times) * 1e3:.1f} ms")


main(*sys.argv[1:])
