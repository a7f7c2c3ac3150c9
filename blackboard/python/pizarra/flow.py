"""Work of several requests, written once for a Board that waits and an AsyncBoard that is awaited.

    def once(pattern) -> Flow[bool]:
        facts = yield from do(ask(pattern))             # a Call, and its answer; what fails is raised here
        yield Pause(0.2)
        return bool(facts)

    board.run(once("(seen ?)")); await async_board.run(once("(seen ?)"))

A flow that is cancelled while it waits just ends there: what it told under a lease goes with the lease.
"""

from __future__ import annotations

from typing import Any, Generator, NamedTuple, TypeVar, Union

from pizarra.answers import Answer
from pizarra.board_calls import Call

T = TypeVar("T")


class Pause(NamedTuple):
    seconds: float


class Keep(NamedTuple):
    """Has the lease renewed that often from now on, whenever the board is spoken with; `every` 0: no longer."""

    lease: int
    every: float


class Until(NamedTuple):
    """The first answer that holds now or comes to hold in time; Failure `timeout`."""

    query: Any
    seconds: float


Step = Union[Call[Any], Pause, Keep, Until]
Flow = Generator[Step, Any, T]


def do(call: Call[T]) -> Flow[T]:
    result: T = yield call
    return result


def until(query: Any, seconds: float) -> Flow[Answer]:
    answer: Answer = yield Until(query, seconds)
    return answer
