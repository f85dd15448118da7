"""Expressions of SymPy as formulas: the tree is walked, and each node is written in the formula language.

What SymPy holds is what is written: it rewrites while it builds, so that ``Eq(sqrt(a**2), a)`` with a positive ``a`` *is*
``True``; what has become ``True`` or ``False`` is refused.
"""

from __future__ import annotations

import sys
from typing import Any, Optional

from .errors import NoCounterpart

__all__ = ["Names", "is_sympy", "relation"]

GREEK = frozenset(
    "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi rho sigma tau upsilon phi chi psi omega "
    "Gamma Delta Theta Lambda Xi Sigma Upsilon Phi Psi Omega varphi vartheta varepsilon varrho hbar ell".split()
)
# `lambda` is a word of Python: SymPy has this spelling for it.
SPELLED = {"lamda": "lambda", "Lamda": "Lambda"}
FUNCTIONS = {
    "sin": r"\sin", "cos": r"\cos", "tan": r"\tan", "cot": r"\cot", "sec": r"\sec", "csc": r"\csc",
    "asin": r"\arcsin", "acos": r"\arccos", "atan": r"\arctan",
    "sinh": r"\sinh", "cosh": r"\cosh", "tanh": r"\tanh", "coth": r"\coth",
    "asinh": r"\operatorname{asinh}", "acosh": r"\operatorname{acosh}", "atanh": r"\operatorname{atanh}",
    "sech": r"\operatorname{sech}", "csch": r"\operatorname{csch}",
    "exp": r"\exp", "log": r"\ln",
    "re": r"\operatorname{Re}", "im": r"\operatorname{Im}", "arg": r"\arg",
}  # fmt: skip
RELATIONS = {
    "Equality": "=", "Unequality": r"\ne ", "StrictLessThan": "<", "LessThan": r"\le ",
    "StrictGreaterThan": ">", "GreaterThan": r"\ge ",
}  # fmt: skip


def is_sympy(value: object) -> bool:
    """Whether something is of SymPy, which is not imported for that."""
    sympy = sys.modules.get("sympy")
    return sympy is not None and isinstance(value, (sympy.Basic, sympy.MatrixBase))


def relation(value: Any) -> Any:
    """A relation of SymPy as it is; an expression, of numbers or of a matrix, as the equation that it is zero."""
    sympy = sys.modules["sympy"]
    if isinstance(value, sympy.MatrixBase):
        return sympy.Eq(value, sympy.zeros(*value.shape), evaluate=False)
    if value == 0:
        raise NoCounterpart("SymPy has made 0 of this expression while it was built, so that nothing is left to check")
    return sympy.Eq(value, 0, evaluate=False) if isinstance(value, sympy.Expr) else value


class Names:
    """What the symbols of SymPy are called in formulas."""

    def __init__(self) -> None:
        self._latex: dict[Any, str] = {}
        self._time: Optional[Any] = None
        # The coordinates of fields, by their functions; and whether derivatives are by coordinates.
        self._fields: dict[Any, tuple[Any, ...]] = {}
        self._partial = False

    def declare(self, symbol: Any, latex: Optional[str] = None) -> tuple[str, str, dict[str, Any]]:
        """The LaTeX name of a symbol, its role, and what is taken over of its assumptions."""
        sympy = sys.modules["sympy"]
        applied = isinstance(symbol, sympy.core.function.AppliedUndef)
        if not applied and not isinstance(symbol, sympy.Symbol):
            raise NoCounterpart(f"a symbol or an applied function is declared, not {symbol!r}")
        if symbol.is_real is False:
            raise NoCounterpart(f"{symbol} is not real: declare it with complex=True, and say what it is in a premise")
        if applied and len(symbol.args) > 1:
            return self._declare_field(symbol, latex)
        if applied and not isinstance(symbol.args[0], sympy.Symbol):
            raise NoCounterpart(f"{symbol} must be a function of the time alone")
        name = self._take(symbol, symbol.func if applied else symbol, latex)
        if applied:
            self._time = symbol.args[0]
        keys: dict[str, Any] = {"positive": True} if symbol.is_positive and not applied else {}
        # Without an assumption a symbol is real here, as formulas have it.
        if symbol.is_complex and symbol.is_real is None:
            keys["complex"] = True
        return name, "state" if applied else "parameter", keys

    def _take(self, symbol: Any, of: Any, latex: Optional[str]) -> str:
        """A name that nothing else has."""
        name = latex or _name(of.__name__ if of is not symbol else symbol.name)
        others = [key for key, own in self._latex.items() if own == name and key != of]
        if others:
            raise NoCounterpart(f"{symbol} and {others[0]} would both be `{name}`: give one of them another `latex=`")
        self._latex[of] = name
        return name

    def _declare_field(self, field: Any, latex: Optional[str]) -> tuple[str, str, dict[str, Any]]:
        """A field, u(x,t): its coordinates are declared before it, the time perhaps not."""
        sympy = sys.modules["sympy"]
        places = field.args
        if not all(isinstance(at, sympy.Symbol) for at in places) or len(set(places)) < len(places):
            raise NoCounterpart(f"{field} must be a function of different coordinates")
        letters = []
        for at in places:
            if at not in self._latex and at != self._time and at.name != "t":
                raise NoCounterpart(f"declare the coordinate {at} before {field}: `.symbol({at}, \"coordinate\")`")
            if at.name == "t" and at not in self._latex:
                self._time = at
            letters.append(self._atom(at))
        name = self._take(field, field.func, latex)
        self._fields[field.func] = places
        self._partial = True
        keys: dict[str, Any] = {"complex": True} if field.is_complex and field.is_real is None else {}
        return f"{name}({','.join(letters)})", "field", keys

    def name(self, symbol: Any) -> str:
        """The name of a symbol, or of a derivative of a function, as a key."""
        return self.latex(symbol)

    def latex(self, expression: Any) -> str:
        """The formula of an expression or a relation."""
        sympy = sys.modules["sympy"]
        if expression in (sympy.true, sympy.false):
            raise NoCounterpart(
                f"SymPy has made {expression} of this relation while it was built, so that nothing is left to check: build it "
                "with evaluate=False"
            )
        relation = RELATIONS.get(type(expression).__name__)
        if relation is not None:
            return f"{self._sum(expression.lhs)}{relation}{self._sum(expression.rhs)}"
        return self._sum(expression)

    def premises(self, relations: Any) -> tuple[list[str], list[str]]:
        """Words and premises for :func:`rederive.prove`, from what stands in relations and its assumptions. Functions are fields,
        and what they are functions of, or derived by, are coordinates."""
        sympy = sys.modules["sympy"]
        symbols = sorted(set().union(*(one.free_symbols for one in relations)), key=str)
        owners, coordinates = _fields_of(relations)
        self._partial = True
        words, given = [], []
        for symbol in symbols + [at for at in coordinates if at not in symbols]:
            name, role, keys = self.declare(symbol)
            if symbol in coordinates:
                role = "coordinate"
                given.extend([f"{name}>0"] if keys.pop("positive", False) else [])
            words.append(", ".join([f"{name}: {role}", *keys]))
            if not keys:
                given.extend(_assumed(name, symbol))
        for function, places in owners.items():
            field = function(*places)
            if field.is_real is False:
                raise NoCounterpart(f"{field} is not real: give its function complex=True, and say what it is in a premise")
            name = self._take(field, function, None)
            self._fields[function] = places
            kind = "field, complex" if field.is_complex and field.is_real is None else "field"
            words.append(f"{name}({','.join(self._latex[at] for at in places)}): {kind}")
            given.extend([f"{name}>0"] if field.is_positive else _assumed(name, field))
        return words, given

    def _sum(self, e: Any) -> str:
        if type(e).__name__ != "Add":
            return self._product(e)
        text = ""
        for term in e.as_ordered_terms():
            one = self._product(term)
            text += one if one.startswith("-") or not text else f"+{one}"
        return text

    def _product(self, e: Any) -> str:
        if type(e).__name__ != "Mul":
            return self._power(e)
        sympy = sys.modules["sympy"]
        sign, factors, below = "", [], []
        for factor in e.args:
            if factor.is_Number and factor.is_negative:
                sign, factor = ("" if sign else "-"), -factor
                if factor == 1:
                    continue
            if factor.is_Pow and factor.exp.is_Number and factor.exp.is_negative:
                below.append(sympy.Pow(factor.base, -factor.exp, evaluate=False) if factor.exp != -1 else factor.base)
            else:
                factors.append(factor)
        above = r"\cdot ".join(self._factor(f) for f in factors) or "1"
        return sign + (f"\\frac{{{above}}}{{{self._joined(below)}}}" if below else above)

    def _joined(self, factors: list[Any]) -> str:
        return self._sum(factors[0]) if len(factors) == 1 else r"\cdot ".join(self._factor(f) for f in factors)

    def _factor(self, e: Any) -> str:
        text = self._power(e)
        return f"\\left({text}\\right)" if type(e).__name__ in ("Add", "Mul") or text.startswith("-") else text

    def _power(self, e: Any) -> str:
        if type(e).__name__ != "Pow":
            return self._atom(e)
        if e.exp.is_Number and e.exp.is_negative:
            below = e.base if e.exp == -1 else type(e)(e.base, -e.exp, evaluate=False)
            return f"\\frac{{1}}{{{self._sum(below)}}}"
        if e.exp.is_Rational and e.exp.q == 2 and e.exp.p == 1:
            return f"\\sqrt{{{self._sum(e.base)}}}"
        base = self._atom(e.base)
        if not (e.base.is_Symbol and "^" not in base and "'" not in base) and not (e.base.is_Integer and e.base >= 0):
            base = f"\\left({self._sum(e.base)}\\right)"
        return f"{base}^{{{self._sum(e.exp)}}}"

    def _atom(self, e: Any) -> str:
        sympy = sys.modules["sympy"]
        kind = type(e).__name__
        if kind in ("Add", "Mul", "Pow"):
            return f"\\left({self._sum(e)}\\right)"
        if e in self._latex:
            return self._latex[e]
        if e is sympy.pi:
            return r"\pi"
        if e is sympy.I:
            return r"\mathrm{i}"
        if kind == "conjugate":
            return f"\\overline{{{self._sum(e.args[0])}}}"
        if e is sympy.E:
            return r"\exp\left(1\right)"
        if kind == "Symbol":
            if e == self._time:
                return "t"
            raise NoCounterpart(f"the symbol {e} is not declared: declare it with `.symbol({e})`")
        if e.is_Integer:
            return str(e)
        if e.is_Rational:
            sign = "-" if e.p < 0 else ""
            return f"{sign}\\frac{{{abs(e.p)}}}{{{e.q}}}"
        if e.is_Float:
            exact = sympy.Rational(str(e))
            return self._atom(exact)
        if kind == "Abs":
            return f"\\left|{self._sum(e.args[0])}\\right|"
        if kind == "sign":
            return f"\\operatorname{{sgn}}\\left({self._sum(e.args[0])}\\right)"
        if kind == "atan2":
            return f"\\operatorname{{atan2}}\\left({self._sum(e.args[0])},{self._sum(e.args[1])}\\right)"
        if kind in FUNCTIONS and len(e.args) == 1:
            return f"{FUNCTIONS[kind]}\\left({self._sum(e.args[0])}\\right)"
        if kind == "Derivative":
            return self._derivative(e)
        if kind == "Subs":
            return self._at_place(e)
        if isinstance(e, sympy.core.function.AppliedUndef):
            return self._applied(e)
        if isinstance(e, sympy.MatrixBase):
            rows = r"\\".join("&".join(self._sum(e[i, j]) for j in range(e.cols)) for i in range(e.rows))
            return f"\\begin{{pmatrix}}{rows}\\end{{pmatrix}}"
        raise NoCounterpart(f"there is no counterpart of SymPy's {kind} in formulas: {e}")

    def _derivative(self, e: Any) -> str:
        dots = {1: r"\dot", 2: r"\ddot", 3: r"\dddot"}
        of, counts = e.expr, e.variable_count
        moves = of.func in self._latex and of.func not in self._fields
        if moves or not self._partial:
            if len(counts) != 1 or not moves or counts[0][0] != self._time or counts[0][1] not in dots:
                raise NoCounterpart(
                    f"only derivatives of declared functions in the time, up to the third, can be written: {e}"
                )
            return f"{dots[int(counts[0][1])]}{{{self._latex[of.func]}}}"
        if not all(n.is_Integer for _, n in counts):
            raise NoCounterpart(f"the order of a derivative is a number: {e}")
        order = sum(int(n) for _, n in counts)
        above = r"\partial" + (f"^{{{order}}}" if order > 1 else "")
        below = "".join(rf"\partial {self._atom(by)}" + (f"^{{{n}}}" if n > 1 else "") for by, n in counts)
        if self._fields.get(of.func) == of.args:
            return f"\\frac{{{above} {self._latex[of.func]}}}{{{below}}}"
        return f"\\frac{{{above}}}{{{below}}}\\left({self._sum(of)}\\right)"

    def _at_place(self, e: Any) -> str:
        """A derivative at a place, as SymPy writes it: of f at x − ct, of u at x = 0."""
        of = e.expr.expr if type(e.expr).__name__ == "Derivative" else None
        own = self._fields.get(of.func) if of is not None else None
        if of is None or own is None or len(e.variables) != 1 or not all(n.is_Integer for _, n in e.expr.variable_count):
            raise NoCounterpart(f"there is no counterpart of {e} in formulas: only a derivative of a function at one place")
        variable, point, counts = e.variables[0], e.point[0], e.expr.variable_count
        # The variable of the place stands for one of the coordinates.
        standing = [at for at, argument in zip(own, of.args) if argument == variable]
        others = [at for at, argument in zip(own, of.args) if argument != variable]
        if len(standing) != 1 or [argument for argument in of.args if argument != variable] != others or variable in others:
            raise NoCounterpart(f"there is no counterpart of {e} in formulas: only a derivative of a function at one place")
        if len(own) == 1:
            primes = "'" * sum(int(n) for _, n in counts)
            return f"{self._latex[of.func]}{primes}\\left({self._sum(point)}\\right)"
        derived = e.expr.xreplace({of: of.func(*own), variable: standing[0]})
        return f"\\left.{self._derivative(derived)}\\right|_{{{self._atom(standing[0])}={self._sum(point)}}}"

    def _applied(self, e: Any) -> str:
        if e.func not in self._latex:
            raise NoCounterpart(f"the function {e.func.__name__} is not declared: declare it with `.symbol({e})`")
        name = self._latex[e.func]
        if e.func in self._fields:
            places = ",".join(self._sum(at) for at in e.args)
            return name if self._fields[e.func] == e.args else f"{name}\\left({places}\\right)"
        return name if e.args[0] == self._time else f"{name}({self._sum(e.args[0])})"


def _assumed(name: str, e: Any) -> list[str]:
    """What SymPy assumes of the sign of something, as a premise."""
    for holds, relation in [
        (e.is_negative, "<0"),
        (e.is_nonnegative, "\\ge 0"),
        (e.is_nonpositive, "\\le 0"),
        (e.is_nonzero, "\\ne 0"),
    ]:
        if holds:
            return [name + relation]
    return []


def _fields_of(relations: Any) -> tuple[dict[Any, tuple[Any, ...]], list[Any]]:
    """The functions in relations with their coordinates, and all coordinates: what functions are functions of, and what is
    derived by. A function that stands at other places only, f(x − c t), has a coordinate of its own."""
    sympy = sys.modules["sympy"]
    undefined = sympy.core.function.AppliedUndef
    applied = sorted(set().union(*(one.atoms(undefined) for one in relations)), key=str)
    owners: dict[Any, tuple[Any, ...]] = {}
    # SymPy's own names for what a derivative at a place is taken by.
    bound = set().union(*(one.atoms(sympy.Dummy) for one in relations))
    for one in applied:
        plain = all(isinstance(at, sympy.Symbol) and at not in bound for at in one.args)
        if plain and len(set(one.args)) == len(one.args):
            owners.setdefault(one.func, one.args)
    taken = {symbol.name for every in relations for symbol in every.free_symbols}
    free = (sympy.Symbol(name) for name in ("xi", "eta", "zeta", "chi", "s", "w") if name not in taken)
    for one in applied:
        if one.func not in owners:
            owners[one.func] = tuple(next(free, sympy.Symbol("xi")) for _ in one.args)
        if len(one.args) != len(owners[one.func]):
            raise NoCounterpart(f"{one.func.__name__} stands with {len(one.args)} and {len(owners[one.func])} arguments")
    derived = {by for every in relations for one in every.atoms(sympy.Derivative) for by, _ in one.variable_count}
    derived -= bound
    if any(not isinstance(by, sympy.Symbol) for by in derived):
        raise NoCounterpart("derivatives are by symbols: SymPy's derivatives by functions have no counterpart")
    coordinates = sorted(derived.union(*owners.values()), key=str)
    return owners, coordinates


def _name(name: str) -> str:
    """The LaTeX of a name such as ``omega_0``."""
    head, *rest = name.split("_")
    if len(rest) > 1:
        raise NoCounterpart(f"the name {name} has two underscores: say what it is in formulas, with `latex=`")
    label = rest[0] if rest else ""
    label = SPELLED.get(label, label)
    if not label:
        # As SymPy prints it: x1 is x with the index 1.
        letters = head.rstrip("0123456789")
        head, label = letters, head[len(letters) :]
    head = SPELLED.get(head, head)
    if head in GREEK:
        head = f"\\{head}"
    elif len(head) != 1 or not head.isalpha():
        raise NoCounterpart(
            f"the name {name} is neither one letter nor a Greek one: take such a name, or say in a Derivation what it is in "
            f"formulas, `.symbol({name}, latex=…)`"
        )
    if not label:
        return head
    if label in GREEK:
        return f"{head}_{{\\{label}}}"
    if len(label) == 1:
        return f"{head}_{label}"
    return f"{head}_{{{label}}}" if label.isdigit() else f"{head}_{{\\rm {label}}}"
