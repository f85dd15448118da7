"""Expressions of SymPy as formulas: the tree is walked, and each node is written in the formula language.

What SymPy holds is what is written: it rewrites while it builds, so that ``Eq(sqrt(a**2), a)`` with a positive ``a`` *is*
``True``; what has become ``True`` or ``False`` is refused.
"""

from __future__ import annotations

import sys
from typing import Any, Optional

from .errors import NoCounterpart

__all__ = ["Names", "is_sympy"]

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


class Names:
    """What the symbols of SymPy are called in formulas."""

    def __init__(self) -> None:
        self._latex: dict[Any, str] = {}
        self._time: Optional[Any] = None

    def declare(self, symbol: Any, latex: Optional[str] = None) -> tuple[str, str, dict[str, Any]]:
        """The LaTeX name of a symbol, its role, and what is taken over of its assumptions."""
        sympy = sys.modules["sympy"]
        applied = isinstance(symbol, sympy.core.function.AppliedUndef)
        if not applied and not isinstance(symbol, sympy.Symbol):
            raise NoCounterpart(f"a symbol or an applied function is declared, not {symbol!r}")
        if symbol.is_real is False:
            raise NoCounterpart(f"{symbol} is not real: declare it with complex=True, and say what it is in a premise")
        if applied and (len(symbol.args) != 1 or not isinstance(symbol.args[0], sympy.Symbol)):
            raise NoCounterpart(f"{symbol} must be a function of the time alone")
        name = latex or _name(symbol.func.__name__ if applied else symbol.name)
        of = symbol.func if applied else symbol
        others = [key for key, own in self._latex.items() if own == name and key != of]
        if others:
            raise NoCounterpart(f"{symbol} and {others[0]} would both be `{name}`: give one of them another `latex=`")
        self._latex[of] = name
        if applied:
            self._time = symbol.args[0]
        keys: dict[str, Any] = {"positive": True} if symbol.is_positive and not applied else {}
        # Without an assumption a symbol is real here, as formulas have it.
        if symbol.is_complex and symbol.is_real is None:
            keys["complex"] = True
        return name, "state" if applied else "parameter", keys

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

    def premises(self, symbols: Any) -> tuple[list[str], list[str]]:
        """Words and premises for :func:`rederive.prove`, from symbols and their assumptions."""
        words, given = [], []
        for symbol in symbols:
            name, role, keys = self.declare(symbol)
            words.append(", ".join([f"{name}: {role}", *keys]))
            if keys or role == "state":
                continue
            if symbol.is_negative:
                given.append(f"{name}<0")
            elif symbol.is_nonnegative:
                given.append(f"{name}\\ge 0")
            elif symbol.is_nonpositive:
                given.append(f"{name}\\le 0")
            elif symbol.is_nonzero:
                given.append(f"{name}\\ne 0")
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
        if isinstance(e, sympy.core.function.AppliedUndef):
            return self._applied(e)
        if isinstance(e, sympy.MatrixBase):
            rows = r"\\".join("&".join(self._sum(e[i, j]) for j in range(e.cols)) for i in range(e.rows))
            return f"\\begin{{pmatrix}}{rows}\\end{{pmatrix}}"
        raise NoCounterpart(f"there is no counterpart of SymPy's {kind} in formulas: {e}")

    def _derivative(self, e: Any) -> str:
        dots = {1: r"\dot", 2: r"\ddot", 3: r"\dddot"}
        of, counts = e.expr, e.variable_count
        if len(counts) != 1 or of.func not in self._latex or counts[0][0] != self._time or counts[0][1] not in dots:
            raise NoCounterpart(f"only derivatives of declared functions in the time, up to the third, can be written: {e}")
        return f"{dots[int(counts[0][1])]}{{{self._latex[of.func]}}}"

    def _applied(self, e: Any) -> str:
        if e.func not in self._latex:
            raise NoCounterpart(f"the function {e.func.__name__} is not declared: declare it with `.symbol({e})`")
        name, at = self._latex[e.func], e.args[0]
        return name if at == self._time else f"{name}({self._sum(at)})"


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
