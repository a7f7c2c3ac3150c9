"""Data: what facts, questions and messages are made of.

A symbol is a Symbol, a string a str, integers and reals are int and float, a list is a list (or a tuple, where one is
given). What is read comes as Any: a fact's shape is its relation's, which a type checker does not know.
"""

from __future__ import annotations

from typing import Any, Dict, Sequence, Union

Datum = Union[str, int, float, Sequence["Datum"]]

# What one message of a board holds.
FRAME_BYTES = 1 << 20
FRAME_DEPTH = 64
FRAME_ELEMENTS = 200_000

WHOLE = range(-1 << 63, 1 << 63)


class Symbol(str):
    """A name; never equal to the string of the same letters."""

    __slots__ = ()

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Symbol) and str.__eq__(self, other)

    def __ne__(self, other: object) -> bool:
        return not self == other

    __hash__ = str.__hash__

    def __repr__(self) -> str:
        return f"Symbol({str.__repr__(self)})"


def elements(datum: Any) -> int:
    return 1 + sum(map(elements, datum)) if isinstance(datum, (list, tuple)) else 1


def is_variable(datum: Any) -> bool:
    return isinstance(datum, Symbol) and datum.startswith("?")


def same(a: Any, b: Any) -> bool:
    """1 and 1.0 are two data, and so are a symbol and a string."""
    if isinstance(a, list) and isinstance(b, list):
        return len(a) == len(b) and all(map(same, a, b))
    return type(a) is type(b) and bool(a == b)


def match(pattern: Any, datum: Any, bindings: Dict[str, Any]) -> bool:
    """Whether the datum fits; what its variables then are is added to `bindings`."""
    if is_variable(pattern):
        return pattern == Symbol("?") or same(bindings.setdefault(str(pattern), datum), datum)
    if isinstance(pattern, list):
        fits = isinstance(datum, list) and len(pattern) == len(datum)
        return fits and all(match(p, d, bindings) for p, d in zip(pattern, datum))
    return same(pattern, datum)
