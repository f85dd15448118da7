"""The text of a derivation file, from its data and back."""

from __future__ import annotations

import sys
from typing import Any, Mapping

if sys.version_info >= (3, 11):
    import tomllib
else:  # pragma: no cover
    import tomli as tomllib

__all__ = ["read", "write"]

BARE = frozenset("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_")


def read(text: str) -> dict[str, Any]:
    """The data of a text; raises ``tomllib.TOMLDecodeError``, a ``ValueError``, with line and column."""
    return tomllib.loads(text)


def write(data: Mapping[str, Any]) -> str:
    """The text of data. Tables of tables have their own headings below the top; everything deeper stands in a line."""
    lines: list[str] = []
    for name, value in data.items():
        if isinstance(value, Mapping) and name == "system":
            for key, table in value.items():
                _table(lines, f"[{_key(name)}.{_key(key)}]", table)
        elif isinstance(value, Mapping):
            _table(lines, f"[{_key(name)}]", value)
        elif isinstance(value, list) and value and all(isinstance(one, Mapping) for one in value):
            for one in value:
                _entries(lines, name, one)
        else:
            lines.insert(0, f"{_key(name)} = {_value(value)}")
    return "\n".join(lines).lstrip("\n") + "\n"


def _entries(lines: list[str], name: str, table: Mapping[str, Any]) -> None:
    readings = {key: of for key, of in table.items() if key == "reading" and isinstance(of, list)}
    _table(lines, f"[[{_key(name)}]]", {key: of for key, of in table.items() if key not in readings})
    for key, of in readings.items():
        for one in of:
            _table(lines, f"[[{_key(name)}.{_key(key)}]]", one)


def _table(lines: list[str], heading: str, table: Mapping[str, Any]) -> None:
    lines += ["", heading]
    lines += [f"{_key(key)} = {_value(value)}" for key, value in table.items()]


def _key(key: str) -> str:
    return key if key and set(key) <= BARE else _text(key, lines=False)


def _value(value: Any) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (int, float)):
        # The shortest decimal digits that give the same number; the program takes them exactly.
        return repr(value)
    if isinstance(value, str):
        return _text(value)
    if isinstance(value, Mapping):
        inside = ", ".join(f"{_key(key)} = {_value(of)}" for key, of in value.items())
        return f"{{ {inside} }}" if inside else "{}"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_value(one) for one in value) + "]"
    raise TypeError(f"a derivation file has no value of the type {type(value).__name__}: {value!r}")


def _text(text: str, lines: bool = True) -> str:
    """Between single quotes where that is possible: formulas must be. Keys are on one line."""
    plain = all(c in "\t\n" or (c >= " " and c != "\x7f") for c in text)
    if plain and "'" not in text and "\n" not in text:
        return f"'{text}'"
    if lines and plain and "'''" not in text and not text.endswith("'"):
        # A line break just after the quotes is no part of the text.
        return f"'''\n{text}'''" if text.startswith("\n") else f"'''{text}'''"
    escapes = {"\\": "\\\\", '"': '\\"', "\n": "\\n", "\t": "\\t", "\r": "\\r"}
    inside = "".join(escapes.get(c, c if c >= " " and c != "\x7f" else f"\\u{ord(c):04x}") for c in text)
    return f'"{inside}"'
