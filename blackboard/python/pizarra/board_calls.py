"""Each request to a board: what is said, whether saying it again is harmless, and what the answer means.

    call = lease(2.0)                # nothing is said yet
    board.run(call), await async_board.run(call)
"""

from __future__ import annotations

from typing import Any, Callable, Generic, Iterable, List, Optional, TypeVar

from pizarra.answers import Answers, Fact, Recalled, answers_from, query_of
from pizarra.datum import Symbol
from pizarra.failure import Failure
from pizarra.writer import datum_of

T = TypeVar("T")


class Call(Generic[T]):
    def __init__(self, body: List[Any], repeatable: bool, understand: Callable[[Any], T]) -> None:
        self.body, self.repeatable, self.understand = body, repeatable, understand

    @property
    def is_question(self) -> bool:
        return bool(self.body[0] == Symbol("ask"))


def _nothing(_: Any) -> None:
    return None


def declare(relations: Iterable[Any]) -> Call[None]:
    return Call([Symbol("declare"), *map(datum_of, relations)], True, _nothing)


def transact(steps: Iterable[Any], preconditions: Iterable[Any] = ()) -> Call[int]:
    return Call([Symbol("transact"), list(preconditions), list(steps)], False, int)


def ask(query: Any) -> Call[Answers]:
    query = query_of(query)

    def understand(value: Any) -> Answers:
        answers = Answers(answers_from(query, value[1:]))
        answers.revision = value[0]
        return answers
    return Call([Symbol("ask"), query], True, understand)


def recall(query: Any) -> Call[Recalled]:
    query = query_of(query)

    def understand(value: Any) -> Recalled:
        recalled = Recalled(answers_from(query, value[3:]))
        recalled.age, recalled.settled, recalled.revision = value[0] / 1e6, value[1] == Symbol("yes"), value[2]
        return recalled
    return Call([Symbol("recall"), query], True, understand)


def take(pattern: Any, lease: int = 0) -> Call[Optional[Fact]]:
    return Call([Symbol("take"), datum_of(pattern), lease], False, lambda value: Fact(value[0]) if value else None)


def lease(seconds: float) -> Call[int]:
    if not isinstance(seconds, (int, float)) or not abs(seconds) < 1e12:
        raise Failure("wrong-shape", "a lease is a number of seconds, at most a year")
    return Call([Symbol("lease"), round(seconds * 1e6)], True, int)


def renew(lease: int) -> Call[None]:
    return Call([Symbol("renew"), lease], True, _nothing)


def release(lease: int) -> Call[None]:
    return Call([Symbol("release"), lease], True, _nothing)
