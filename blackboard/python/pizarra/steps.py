"""What a transaction is made of: steps that are done together, and preconditions without which none is.

    board.transact([settle(fact.id), tell("(done 1)")], preconditions=[absent("(stopped ?)")])
"""

from __future__ import annotations

from typing import Any, Iterable, List

from pizarra.datum import Symbol
from pizarra.writer import datum_of


def tell(fact: Any, lease: int = 0, because: Iterable[int] = ()) -> List[Any]:
    return [Symbol("tell"), datum_of(fact), lease, *because]


def retract(pattern: Any) -> List[Any]:
    return [Symbol("retract"), datum_of(pattern)]


def settle(taken: int) -> List[Any]:
    """What was taken is done with, and is not put back."""
    return [Symbol("settle"), taken]


def present(pattern: Any) -> List[Any]:
    return [Symbol("present"), datum_of(pattern)]


def absent(pattern: Any) -> List[Any]:
    return [Symbol("absent"), datum_of(pattern)]


def unchanged(pattern: Any, revision: int) -> List[Any]:
    """Nothing that fits came or went since."""
    return [Symbol("unchanged"), datum_of(pattern), revision]
