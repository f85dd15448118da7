"""How many true identities are proved, beside `simplify` and `equals` of SymPy?

In: the compiled program, and SymPy with its own tests. A development tool, run by hand:

    python tests/sympy_identities.py collect identities.json
    python tests/sympy_identities.py compare target/release/rederive identities.json 1715

`collect` runs SymPy's tests and records what `simplify`, `expand`, `rewrite` and the like turn into what: pairs that SymPy itself
takes for equal. Kept are those of elementary functions and of real symbols that agree at random points where both sides are real.
`compare` asks for a sample of them `rederive prove`, a process of its own whose start counts, and `simplify(left - right) == 0`
and `left.equals(right)` with the same assumptions, each from an empty cache and for at most 20 s. The set favours SymPy, which
made it. Out: how many each proves, of all and of those that are read; processor seconds, sum and median.
"""

import importlib
import json
import pkgutil
import random
import resource
import signal
import statistics
import subprocess
import sys
from collections import Counter

import sympy
from sympy import Expr, Symbol


class Late(BaseException):
    """It took too long."""


def late(*_):
    raise Late


signal.signal(signal.SIGALRM, late)


MOST = 60_000
FUNCTIONS = {
    "sympy.simplify.simplify": ["simplify", "logcombine", "nsimplify"],
    "sympy.simplify.trigsimp": ["trigsimp", "exptrigsimp", "trigsimp_groebner"],
    "sympy.simplify.powsimp": ["powsimp", "powdenest"],
    "sympy.simplify.radsimp": ["radsimp", "collect", "rcollect", "collect_sqrt"],
    "sympy.simplify.ratsimp": ["ratsimp"],
    "sympy.simplify.fu": [
        "fu", "TR0", "TR1", "TR2", "TR2i", "TR3", "TR4", "TR5", "TR6", "TR7", "TR8", "TR9", "TR10", "TR10i", "TR11", "TR12",
        "TR12i", "TR13", "TR14", "TR15", "TR16", "TR111", "TR22", "TRpower", "TRmorrie",
    ],
    "sympy.simplify.sqrtdenest": ["sqrtdenest"],
    "sympy.simplify.combsimp": ["combsimp"],
    "sympy.core.function": [
        "expand", "expand_mul", "expand_log", "expand_trig", "expand_power_exp", "expand_power_base", "expand_multinomial",
        "expand_complex",
    ],
    "sympy.polys.polytools": ["factor", "cancel"],
    "sympy.polys.rationaltools": ["together"],
    "sympy.polys.partfrac": ["apart"],
    "sympy.simplify.hyperexpand": ["hyperexpand"],
}
METHODS = ["rewrite", "expand", "simplify", "trigsimp", "factor", "together", "apart", "cancel", "radsimp", "powsimp", "ratsimp"]
TESTS = ["sympy.simplify.tests", "sympy.functions.elementary.tests", "sympy.core.tests", "sympy.polys.tests.test_partfrac"]
ABOUT = [
    "simplify.tests.test_simplify", "fu", "trigsimp", "powsimp", "radsimp", "ratsimp", "sqrtdenest", "hyperbolic", "trigonometric",
    "exponential", "miscellaneous", "complexes", "test_expand", "test_expr", "test_arit", "test_function", "partfrac", "rewrite",
    "combsimp",
]
ELEMENTARY = (
    sympy.Add, sympy.Mul, sympy.Pow, sympy.Symbol, sympy.Rational, sympy.exp, sympy.log, sympy.sin, sympy.cos, sympy.tan, sympy.cot,
    sympy.sec, sympy.csc, sympy.asin, sympy.acos, sympy.atan, sympy.sinh, sympy.cosh, sympy.tanh, sympy.coth, sympy.sech, sympy.csch,
    sympy.asinh, sympy.acosh, sympy.atanh, sympy.Abs, sympy.atan2, type(sympy.pi), type(sympy.E),
)


def recorded():
    """What SymPy's tests turn into what."""
    pairs = []

    def spying(function):
        def spy(*arguments, **options):
            result = function(*arguments, **options)
            before = arguments[0] if arguments else None
            of_use = isinstance(before, Expr) and isinstance(result, Expr) and before != result
            # What is forced need not be true.
            if of_use and "force" not in options and len(pairs) < MOST:
                pairs.append((before, result))
            return result

        return spy

    for module, names in FUNCTIONS.items():
        for name in names:
            old = getattr(importlib.import_module(module), name, None)
            if old is None:
                continue
            new = spying(old)
            for other in list(sys.modules.values()):
                if getattr(other, "__name__", "").startswith("sympy") and getattr(other, name, None) is old:
                    setattr(other, name, new)
    for name in METHODS:
        if hasattr(Expr, name):
            setattr(Expr, name, spying(getattr(Expr, name)))
    modules = []
    for base in TESTS:
        package = importlib.import_module(base)
        inside = pkgutil.iter_modules(package.__path__) if hasattr(package, "__path__") else []
        modules += [f"{base}.{m.name}" for m in inside if m.name.startswith("test_")] or [base]
    for module in (m for m in modules if any(a in m for a in ABOUT)):
        for name, test in list(vars(importlib.import_module(module)).items()):
            if name.startswith("test_") and callable(test):
                signal.alarm(20)
                try:
                    test()
                except KeyboardInterrupt:
                    raise
                except BaseException:  # A test that is late, or fails under observation, has recorded what it could.
                    pass
                finally:
                    signal.alarm(0)
    return pairs


def agree(left, right, symbols, draws):
    """Whether both sides are real and equal wherever they have values at random points; None where they have none."""
    found = None
    for _ in range(24):
        at = {s: draws.uniform(0.1, 3) if s.is_positive else draws.uniform(-3, 3) for s in symbols}
        try:
            signal.alarm(5)
            x, y = (complex(side.evalf(30, subs=at)) for side in (left, right))
        except (Late, Exception):
            continue
        finally:
            signal.alarm(0)
        real = all(abs(z.imag) <= 1e-12 * (1 + abs(z)) and abs(z) < 1e12 for z in (x, y))
        if not real:
            continue
        if abs(x - y) > 1e-9 * (1 + abs(x) + abs(y)):
            return False
        found = True
    return found


def collect(path):
    """Writes the identities."""
    draws, seen, out = random.Random(1), set(), []
    for left, right in recorded():
        nodes = [n for side in (left, right) for n in sympy.preorder_traversal(side)]
        if len(nodes) > 160 or not all(isinstance(n, ELEMENTARY) and type(n) is not sympy.Dummy for n in nodes):
            continue
        key = frozenset((sympy.srepr(left), sympy.srepr(right)))
        if key in seen:
            continue
        seen.add(key)
        symbols = sorted(left.free_symbols | right.free_symbols, key=lambda s: s.name)
        other = lambda s: s.is_integer or not s.is_commutative or s.is_imaginary or s.is_negative or len(s.name) > 1 or s.name in "eidt"
        if any(other(s) for s in symbols) or len({s.name for s in symbols}) != len(symbols):
            continue
        if agree(left, right, symbols, draws):
            out.append({
                "symbols": [(s.name, bool(s.is_positive)) for s in symbols],
                "left": sympy.srepr(left),
                "right": sympy.srepr(right),
                "latex": f"{sympy.latex(left)}={sympy.latex(right)}",
            })
    with open(path, "w", encoding="utf-8") as file:
        json.dump(out, file)
    print(len(out), "identities")


def seconds(who):
    usage = resource.getrusage(who)
    return usage.ru_utime + (usage.ru_stime if who == resource.RUSAGE_CHILDREN else 0)


def timed(answer):
    """Whether SymPy says yes, and how long that takes."""
    sympy.core.cache.clear_cache()
    begun = seconds(resource.RUSAGE_SELF)
    signal.alarm(20)
    try:
        yes = bool(answer())
    except (Late, Exception):
        yes = False
    finally:
        signal.alarm(0)
    return yes, seconds(resource.RUSAGE_SELF) - begun


def compare(program, path, count):
    """Prints the table."""
    with open(path, encoding="utf-8") as file:
        identities = json.load(file)
    random.Random(7).shuffle(identities)
    rows = []
    for one in identities[:count]:
        asked = [program, "prove", one["latex"]]
        for name, positive in one["symbols"]:
            asked += ["--symbol", name + (": positive" if positive else "")]
        begun = seconds(resource.RUSAGE_CHILDREN)
        said = subprocess.run(asked, capture_output=True, text=True, check=False)
        took = seconds(resource.RUSAGE_CHILDREN) - begun
        left, right = (eval(one[side], dict(vars(sympy))) for side in ("left", "right"))
        alike = {
            s: Symbol(s.name, positive=True) if s.is_positive else Symbol(s.name, real=True)
            for s in left.free_symbols | right.free_symbols
        }
        left, right = left.xreplace(alike), right.xreplace(alike)
        simplify = timed(lambda: sympy.simplify(left - right) == 0)
        equals = timed(lambda: left.equals(right))
        rows.append(((said.stdout or "refused").split("\n")[0], took, simplify, equals))
    print(Counter(ours for ours, *_ in rows))
    for title, chosen in [("all", rows), ("read", [r for r in rows if r[0] != "refused"])]:
        proved = sum(r[0] == "proved" for r in chosen)
        simplify, equals, either = (sum(f(r) for r in chosen) for f in (lambda r: r[2][0], lambda r: r[3][0], lambda r: r[2][0] or r[3][0]))
        print(f"{title}: {len(chosen)}; rederive {proved}, simplify {simplify}, equals {equals}, either of these {either}")
        for name, times in [("rederive", [r[1] for r in chosen]), ("simplify", [r[2][1] for r in chosen]), ("equals", [r[3][1] for r in chosen])]:
            print(f"  {name}: {sum(times):.1f} s, median {1000 * statistics.median(times):.1f} ms")


if __name__ == "__main__":
    if sys.argv[1] == "collect":
        collect(sys.argv[2])
    else:
        compare(sys.argv[2], sys.argv[3], int(sys.argv[4]))
