"""Data to text, or a Failure `bad-datum` where a value is no datum.

    write([Symbol("seen"), "circle", 112.5])        # (seen "circle" 112.5)
"""

from __future__ import annotations

import math
import re
from typing import Any

from pizarra.datum import FRAME_DEPTH, WHOLE, Symbol
from pizarra.failure import Failure
from pizarra.reader import LETTERS, NO_TEXT, read

_SYMBOL = re.compile(rf"(?![+-]?\.?[0-9])(?!\.\Z){LETTERS}\Z")
_TO_ESCAPE = re.compile(r'[\\"\n\t]')
_ESCAPES = {"\\": "\\\\", '"': '\\"', "\n": "\\n", "\t": "\\t"}
TELLER_BYTES = 128


def write(datum: Any, deepest: int = FRAME_DEPTH) -> str:
    if isinstance(datum, str):
        return _symbol(datum) if isinstance(datum, Symbol) else _string(datum)
    if isinstance(datum, (list, tuple)):
        if deepest == 0:
            raise Failure("too-large", "lists nest deeper than the board takes them")
        return "(" + " ".join([write(item, deepest - 1) for item in datum]) + ")"
    if isinstance(datum, int) and not isinstance(datum, bool) and datum in WHOLE:
        return int.__repr__(datum)
    if isinstance(datum, float) and math.isfinite(datum):
        return float.__repr__(datum)
    kind = "out of range" if isinstance(datum, (int, float)) and not isinstance(datum, bool) else "no datum"
    raise Failure("bad-datum", f"a value of the type {type(datum).__name__} is {kind}: "
                               "data are lists, Symbols, strings, integers of 64 bits and finite reals")


def datum_of(given: Any) -> Any:
    """A text is read; data are taken as they are."""
    return read(given) if isinstance(given, str) and not isinstance(given, Symbol) else given


def check_teller(name: str) -> None:
    """Agents speak of who asked them by that name, as a symbol, which must not be a variable."""
    if not _SYMBOL.match(name) or name.startswith("?"):
        raise Failure("bad-name", f"no teller is called {str.__repr__(name)[:60]}: the name is a symbol's, of letters, "
                                  "digits, dashes and the like, without blanks, no digit and no question mark first", name)
    if len(name) > TELLER_BYTES:
        raise Failure("too-large", f"the name of a teller has at most {TELLER_BYTES} bytes")


def _symbol(datum: Symbol) -> str:
    if not _SYMBOL.match(datum):
        raise Failure("bad-datum", f"{str.__repr__(datum)[:60]} is no symbol")
    return str(datum)


def _string(datum: str) -> str:
    if NO_TEXT.search(datum):
        raise Failure("bad-datum", "no string holds a NUL or half a character")
    return '"' + _TO_ESCAPE.sub(lambda letter: _ESCAPES[letter[0]], datum) + '"'
