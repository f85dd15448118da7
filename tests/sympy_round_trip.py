"""Are formulas that SymPy prints read as what they mean?

In: the compiled program and a number of formulas. A development tool, run by hand with a Python that has SymPy:

    python tests/sympy_round_trip.py target/debug/rederive 4000

Random formulas of parameters, of functions of the time and of their derivatives are printed by `sympy.latex`, and put into
derivation files as measures. The program refuses a formula, or evaluates it; the value is compared with that of SymPy at
thirty digits. Out: how many were read and agree, how many were refused with which code, and every formula that was read as
something else. The exit code is 1 if there is one.
"""

import collections
import json
import pathlib
import random
import subprocess
import sys
import tempfile

import sympy as s

t = s.Symbol("t", real=True)
a, b, c, k, x = s.symbols("a b c k x", real=True)
m, w, q = s.symbols("m omega q_1", positive=True)
f, g = s.Function("f"), s.Function("g")

PARAMETERS = {a: s.Rational(7, 10), b: s.Rational(-13, 10), c: s.Rational(21, 10), k: s.Integer(3), x: s.Rational(2, 5)}
POSITIVE = {m: s.Rational(3, 2), w: s.Rational(17, 10), q: s.Rational(1, 3)}
VALUES = PARAMETERS | POSITIVE
MOTION = {f: s.sin(s.Rational(13, 10) * t) + 2 * t**2 + s.Rational(3, 10), g: s.exp(-t) * (1 + t**3)}
NOW = s.Rational(1, 2)

ONE = [s.sin, s.cos, s.tan, s.exp, s.log, s.sqrt, s.Abs, s.sinh, s.cosh, s.tanh, s.asin, s.acos, s.atan, s.asinh, s.acosh,
       s.atanh, s.sec, s.csc, s.cot, s.coth, s.sech, s.csch, s.sign, s.floor, s.ceiling, s.Heaviside, s.factorial]
LEAVES = [a, b, c, k, x, m, w, q, t, f(t), g(t), f(t).diff(t), g(t).diff(t, 2), f(t).diff(t, 3), s.pi, s.E]
STYLES = [{}, {}, {"fold_short_frac": True}, {"ln_notation": True}, {"fold_frac_powers": True},
          {"inv_trig_style": "full"}, {"inv_trig_style": "power"}, {"mul_symbol": "dot"}, {"mul_symbol": "times"},
          {"root_notation": False}, {"long_frac_ratio": 1}, {"order": "grlex"},
          {"mode": "plain", "diff_operator": "rd"}]


def draw(rng, depth):
    """A random formula."""
    if depth == 0 or rng.random() < 0.12:
        kind = rng.random()
        if kind < 0.2:
            return s.Integer(rng.randint(-4, 9))
        if kind < 0.27:
            return s.Rational(rng.randint(-9, 9), rng.randint(2, 7))
        if kind < 0.31:
            return s.Float(rng.choice([0.5, 1.25, -2.75, 1e-5, 3e8]))
        return rng.choice(LEAVES)
    kind = rng.random()
    if kind < 0.3:
        return s.Add(*(draw(rng, depth - 1) for _ in range(rng.randint(2, 3))))
    if kind < 0.6:
        return s.Mul(*(draw(rng, depth - 1) for _ in range(rng.randint(2, 4))))
    if kind < 0.7:
        return draw(rng, depth - 1) / draw(rng, depth - 1)
    if kind < 0.82:
        powers = [2, 3, -1, -2, s.Rational(1, 2), s.Rational(-1, 2), s.Rational(1, 3), s.Rational(3, 2), k, a, x]
        return draw(rng, depth - 1) ** rng.choice(powers)
    if kind < 0.85:
        return s.Derivative(draw(rng, depth - 1), t)
    if kind < 0.87:
        return s.atan2(draw(rng, depth - 1), draw(rng, depth - 1))
    return rng.choice(ONE)(draw(rng, depth - 1))


def value(formula):
    """Its value at the time, where it has a real one."""
    put = formula.subs({function(t): motion for function, motion in MOTION.items()}).doit()
    number = put.subs(VALUES).subs(t, NOW).evalf(30)
    if not number.is_number or number.has(s.nan, s.zoo, s.oo, s.I):
        return None
    return number if number.is_Float or number.is_Integer or number.is_Rational else None


def file(formulas):
    """A derivation file with the formulas as measures, and the line of each."""
    lines = ["[derivation]", 'title = "Formulas"', 'concerns = "SymPy"', "[conventions]", 'log = "natural"', "[symbols]",
             "'t' = { role = \"time\" }", "'f' = { role = \"state\" }", "'g' = { role = \"state\" }"]
    lines += [f"'{s.latex(v)}' = {{ role = \"parameter\" }}" for v in VALUES]
    given = ", ".join(f"'{s.latex(v)}' = '{s.latex(n)}'" for v, n in VALUES.items())
    motion = r"""{ 'f' = '\sin(1.3t)+2t^2+0.3', 'g' = 'e^{-t}(1+t^3)' }"""
    lines += ["[[trajectory]]", 'id = "m"', f"formula = {motion}", f"parameters = {{ {given} }}", "span = [0, 1]",
              "initial-time = 0.5", "[[claim]]", 'id = "c"', 'says = "nothing"', "always = ['a=a']"]
    at = {}
    for number, formula in formulas.items():
        lines += ["[[measure]]", f'id = "m{number}"', 'says = "it"', f"formula = '{formula}'"]
        at[len(lines)] = number
    return "\n".join(lines) + "\n", at


def run(program, text):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder, "formulas.toml")
        path.write_text(text)
        command = [program, "check", str(path), "--no-reports", "--format", "json"]
        done = subprocess.run(command, capture_output=True, text=True, cwd=folder)
        return done.stdout, done.stderr


def refusals(stderr, at):
    """The codes of the problems, by formula."""
    code, out = None, {}
    for line in stderr.splitlines():
        if line.startswith("error["):
            code = line[6 : line.index("]")]
        elif "-->" in line and code:
            number = at.get(int(line.rsplit(":", 2)[1]))
            if number is None:
                sys.exit(stderr)
            out.setdefault(number, code)
            code = None
    return out


def main():
    program, count = str(pathlib.Path(sys.argv[1]).resolve()), int(sys.argv[2])
    rng = random.Random(sys.argv[3] if len(sys.argv) > 3 else "1")
    formulas, meant = {}, {}
    while len(formulas) < count:
        try:
            formula = draw(rng, rng.randint(1, 3))
            text = s.latex(formula, **rng.choice(STYLES))
            number = value(formula)
        except (ValueError, TypeError, ZeroDivisionError, OverflowError, AttributeError, NotImplementedError, RecursionError):
            continue
        if formula.has(s.zoo, s.nan, s.oo, s.I) or "'" in text:
            continue
        if number is not None and (abs(number) > 1e60 or (number != 0 and abs(number) < 1e-60)):
            continue
        formulas[len(formulas)], meant[len(meant)] = text, number
    codes, wrong = collections.Counter(), []
    examples = collections.defaultdict(list)
    agree = none = missing = 0
    numbers = list(formulas)
    for start in range(0, count, 200):
        left = {n: formulas[n] for n in numbers[start : start + 200]}
        for _ in range(20):
            text, at = file(left)
            stdout, stderr = run(program, text)
            if stdout.strip():
                break
            refused = refusals(stderr, at)
            if not refused:
                sys.exit(stderr)
            for n, code in refused.items():
                codes[code] += 1
                examples[code].append(left.pop(n))
        found = {entry["measure"]: entry["values"] for entry in json.loads(stdout)["measurements"]}
        for n, formula in left.items():
            values = found.get(f"m{n}")
            got = values[0]["value"] if values else None
            if got is None:
                if meant[n] is None:
                    none += 1
                else:
                    missing += 1
                    examples["no value"].append(f"{formula}    SymPy: {s.N(meant[n], 8)}")
            elif meant[n] is None:
                wrong.append((formula, got, "no real value"))
            elif abs(s.Float(got, 30) - meant[n]) > 1e-8 * max(1, abs(meant[n])):
                wrong.append((formula, got, s.N(meant[n], 12)))
            else:
                agree += 1
    print(f"{count} formulas: {agree} read and equal, {none} read and without value for both, {missing} without value here")
    print(f"{sum(codes.values())} refused:", ", ".join(f"{n} {code}" for code, n in codes.most_common()))
    shown = int(sys.argv[4]) if len(sys.argv) > 4 else 0
    for code, texts in examples.items():
        for text in sorted(texts, key=len)[:shown]:
            print(f"  {code}: {text}")
    print(f"{len(wrong)} read as something else")
    for formula, got, meaning in wrong:
        print(f"  {formula}: {got}, SymPy {meaning}")
    sys.exit(bool(wrong))


main()
