"""Text to data.

    read('(seen "circle" 112.5)')        # [Symbol("seen"), "circle", 112.5]
    read_all("a (b)")                    # [Symbol("a"), [Symbol("b")]]

What a board would not read is not read here either, and fails in its words.
"""

from __future__ import annotations

import math
import re
from typing import Any, List

from pizarra.datum import WHOLE, Symbol
from pizarra.failure import Failure

LETTERS = r"[A-Za-z0-9!$%&*/:<=>?^_~+\-.@]+"
_TOKEN = re.compile(rf'[ \t\r\n]+|;[^\n]*|([()])|"((?:[^"\\]|\\.)*)"|({LETTERS})', re.DOTALL)
_NUMBER_LIKE = re.compile(r"[+-]?\.?[0-9]")
_NUMBER = re.compile(r"([+-]?[0-9]+(?:\.[0-9]+)?)([eE][+-]?[0-9]+)?\Z")
NO_TEXT = re.compile("[\0\ud800-\udfff]")
_UNESCAPED = {"n": "\n", "t": "\t", '"': '"', "\\": "\\"}


def read(text: str) -> Any:
    """The one datum that the text holds."""
    data = read_all(text)
    if len(data) != 1:
        raise Failure("more-than-one" if data else "nothing-to-read", "a text holds one datum")
    return data[0]


def read_all(text: str) -> List[Any]:
    if NO_TEXT.search(text):
        raise Failure("bad-text", "no text holds a NUL or half a character")
    stack: List[List[Any]] = [[]]
    at = 0
    while at < len(text):
        token = _TOKEN.match(text, at)
        if not token:
            symbol = "unclosed-string" if text[at] == '"' else "bad-character"
            raise Failure(symbol, f"this is no datum from character {at} on: {text[at:at + 20]!r}")
        at = token.end()
        if token[1] == "(":
            stack.append([])
        elif token[1] == ")":
            if len(stack) == 1:
                raise Failure("unexpected-close", "a ) that closes nothing")
            done = stack.pop()
            stack[-1].append(done)
        elif token[2] is not None:
            stack[-1].append(_string(token[2]))
        elif token[3] is not None:
            stack[-1].append(_atom(token[3]))
    if len(stack) > 1:
        raise Failure("unclosed-list", "a list is not closed")
    return stack[0]


def _string(text: str) -> str:
    if "\\" not in text:
        return text
    try:
        return re.sub(r"\\(.)", lambda escape: _UNESCAPED[escape[1]], text, flags=re.DOTALL)
    except KeyError as escape:
        raise Failure("bad-escape", f"a string has no escape of {escape}") from None


def _atom(text: str) -> Any:
    if not _NUMBER_LIKE.match(text):
        if text == ".":
            raise Failure("bad-character", "a dot has no meaning here")
        return Symbol(text)
    number = _NUMBER.match(text)
    if not number:
        raise Failure("bad-number", f"{text[:40]} begins like a number but is none")
    value: float
    if set(text) & set(".eE"):
        value = float(text)
        fits = math.isfinite(value) and (value != 0 or not set(number[1]) & set("123456789"))
    else:
        value = int(text) if len(text.lstrip("+-0")) < 20 else WHOLE.stop
        fits = value in WHOLE
    if not fits:
        raise Failure("bad-number", f"{text[:40]} is too large, or too small, for a number")
    return value
