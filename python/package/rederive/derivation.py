"""A derivation, written in Python: :class:`Derivation`.

Formulas are texts in LaTeX, or expressions of SymPy. What is built is the data of a derivation file, so that every key of
such a file can be given, and a file that is read and written again says the same.
"""

from __future__ import annotations

from copy import deepcopy
from typing import Any, Mapping, Optional

from . import toml_text
from .formula import Names, is_sympy, relation

__all__ = ["Derivation"]

Data = dict[str, Any]
# What of a claim is a relation, so that an expression of SymPy says that it is zero.
RELATIONS = frozenset("always never eventually".split())
# What of a claim is a list, so that one alone may be given without brackets.
SEVERAL = frozenset(
    "always never eventually first_integral defined assuming trajectories families follows_from rests_on".split()
)


class Derivation:
    """The data of a derivation file, table by table.

    Every method returns the derivation, so that calls can be chained. Keys with a hyphen are written with an underscore,
    ``first_integral=…``; where a formula is expected, an expression of SymPy may stand: its symbols must be declared before,
    by :meth:`symbol`.
    """

    def __init__(self, title: str, concerns: str = "", **keys: Any) -> None:
        self._names = Names()
        self._data: Data = {"derivation": {"title": title, "concerns": concerns or title, **self._keys(keys)}}

    @classmethod
    def from_toml(cls, text: str) -> Derivation:
        """From the text of a derivation file; comments are not kept."""
        made = cls("")
        made._data = toml_text.read(text)
        return made

    def to_toml(self) -> str:
        """The text of a derivation file."""
        return toml_text.write(self._data)

    @property
    def data(self) -> Data:
        """The tables of the file."""
        return deepcopy(self._data)

    def convention(self, name: str, says: str) -> Derivation:
        self._data.setdefault("conventions", {})[name] = says
        return self

    def symbol(self, name: Any, role: Optional[str] = None, *, latex: Optional[str] = None, **keys: Any) -> Derivation:
        """Declares a symbol: its LaTeX name, or a symbol or function of SymPy, whose assumptions are taken over.

        ``role`` is ``"parameter"`` unless given, and ``"state"`` for an applied function such as ``q(t)``, and
        ``"field"`` for one of several coordinates, ``u(x, t)``, which are declared before it. ``latex`` is what a symbol of
        SymPy is called in formulas.
        """
        if is_sympy(name):
            latex, own_role, taken = self._names.declare(name, latex)
            role = role or own_role
            keys = {**taken, **keys}
        else:
            latex = str(name)
        keys = self._keys(keys)
        self._data.setdefault("symbols", {})[latex] = {"role": role or "parameter", **keys}
        return self

    def system(self, id: str, states: Any, equations: Any, **keys: Any) -> Derivation:
        """A system of differential equations; ``states`` is ``None`` where it has ``fields``."""
        unknowns = {} if states is None else {"states": _several(states)}
        keys = self._keys({**keys, **unknowns, "equations": _several(equations)})
        self._data.setdefault("system", {})[id] = keys
        return self

    def trajectory(self, id: str, **keys: Any) -> Derivation:
        """A motion on which claims are tried: ``system``, ``parameters``, ``initial``, ``span``, and so on."""
        self._data.setdefault("trajectory", []).append({"id": id, **self._keys(keys)})
        return self

    def claim(self, id: str, says: str, **keys: Any) -> Derivation:
        """What the paper says: ``always``, ``never``, ``first_integral``, ``solves``, with ``assuming``, ``expect``, and so on."""
        self._data.setdefault("claim", []).append({"id": id, "says": says, **self._forms(keys)})
        return self

    def reading(self, id: str, says: str, **keys: Any) -> Derivation:
        """A reading of the claim before it."""
        if not self._data.get("claim"):
            raise ValueError("a reading belongs to the claim before it, and there is none")
        self._data["claim"][-1].setdefault("reading", []).append({"id": id, "says": says, **self._forms(keys)})
        return self

    def table(self, kind: str, **keys: Any) -> Derivation:
        """Any other table: ``family``, ``measure``, ``condition``, ``picture``."""
        self._data.setdefault(kind, []).append(self._keys(keys))
        return self

    def latex(self, expression: Any) -> str:
        """An expression of SymPy as a formula, with the names that were declared."""
        return self._names.latex(expression)

    def _forms(self, keys: Mapping[str, Any]) -> Data:
        several = {key: _several(value) if key in SEVERAL else value for key, value in keys.items()}
        return self._keys({key: _related(value) if key in RELATIONS else value for key, value in several.items()})

    def _keys(self, keys: Mapping[str, Any]) -> Data:
        # A word of Python's own is written with an underscore after it, `from_`.
        return {key.rstrip("_").replace("_", "-"): self._value(value) for key, value in keys.items() if value is not None}

    def _value(self, value: Any) -> Any:
        if is_sympy(value):
            return self._names.latex(value)
        if isinstance(value, Mapping):
            return {self._names.name(key) if is_sympy(key) else str(key): self._value(of) for key, of in value.items()}
        if isinstance(value, (list, tuple)):
            return [self._value(one) for one in value]
        # Numbers of NumPy and their like.
        return value.item() if hasattr(value, "item") and callable(value.item) else value

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Derivation) and self._data == other._data

    def __hash__(self) -> int:
        return hash(self.to_toml())

    def __getstate__(self) -> Data:
        return self._data

    def __setstate__(self, state: Data) -> None:
        self._data, self._names = state, Names()

    def __repr__(self) -> str:
        count = {kind: len(of) for kind, of in self._data.items() if kind != "derivation"}
        parts = ", ".join(f"{kind}: {n}" for kind, n in count.items())
        return f"<Derivation {self._data['derivation']['title']!r}{'; ' if parts else ''}{parts}>"


def _related(values: list[Any]) -> list[Any]:
    """Of SymPy's expressions the equations that they are zero."""
    return [relation(one) if is_sympy(one) else one for one in values]


def _several(value: Any) -> list[Any]:
    """One formula is a list of one."""
    return list(value) if isinstance(value, (list, tuple)) else [value]
