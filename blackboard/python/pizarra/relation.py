"""A relation as it is declared, (relation NAME ((ARGUMENT TYPE) ...) OPTION ...), and what has its shape.

    seen = Relation("(relation seen ((name string) (x number)) (key name))")
    seen.fits_pattern([Symbol("seen"), Symbol("?name"), 1])
"""

from __future__ import annotations

from typing import Any, Callable, Dict, List, NamedTuple

from pizarra.datum import Symbol, is_variable
from pizarra.failure import Failure
from pizarra.writer import datum_of, write

TYPES: Dict[str, Callable[[Any], bool]] = {
    "symbol": lambda value: isinstance(value, Symbol),
    "string": lambda value: isinstance(value, str) and not isinstance(value, Symbol),
    "integer": lambda value: isinstance(value, int) and not isinstance(value, bool),
    "number": lambda value: isinstance(value, (int, float)) and not isinstance(value, bool),
    "list": lambda value: isinstance(value, (list, tuple)),
    "datum": lambda value: True,
}


class Argument(NamedTuple):
    name: str
    type: str

    def fits(self, value: Any) -> bool:
        return TYPES[self.type](value)


def argument_of(form: Any) -> Argument:
    right = isinstance(form, list) and len(form) == 2 and all(isinstance(word, Symbol) for word in form)
    if not right or str(form[1]) not in TYPES:
        raise Failure("wrong-shape", "an argument is (NAME TYPE) with the type symbol, string, integer, number, list or "
                                     f"datum: not {write(form)[:60]}", form)
    return Argument(str(form[0]), str(form[1]))


class Relation:
    def __init__(self, given: Any) -> None:
        form = datum_of(given)
        right = isinstance(form, list) and len(form) > 2 and form[0] == Symbol("relation") and isinstance(form[2], list)
        if not right or not isinstance(form[1], Symbol):
            raise Failure("wrong-shape", "a relation is (relation NAME ((ARGUMENT TYPE) ...) OPTION ...): "
                                         f"not {write(form)[:60]}", form)
        self.form, self.name = form, str(form[1])
        self.arguments = [argument_of(argument) for argument in form[2]]
        self.key = self._key([option[1:] for option in form[3:] if option[:1] == [Symbol("key")]])

    def _key(self, keys: List[List[Any]]) -> List[int]:
        """The places of the key's arguments: of all where none is named."""
        names = [argument.name for argument in self.arguments]
        if not keys:
            return list(range(len(names)))
        try:
            return sorted(names.index(str(name)) for name in keys[0])
        except ValueError:
            raise Failure("wrong-shape", "the key names an argument that is not there", self.form) from None

    def everything(self) -> List[Any]:
        return [Symbol(self.name), *(Symbol(f"?{place}") for place in range(len(self.arguments)))]

    def fits_pattern(self, pattern: List[Any]) -> bool:
        """Its arguments' number, and the types of those that are given."""
        given = pattern[1:]
        return len(given) == len(self.arguments) and all(
            is_variable(value) or argument.fits(value) for argument, value in zip(self.arguments, given))
