"""Requests of a client, numbered: which wait for an answer, and which may go.

    requests = Requests(link.send)
    request = requests.begin([Symbol("ask"), query], repeatable=True)
    requests.transmit(session, lambda request: request.sent is None)
    requests.finish(1, [value])                     # request.result is [value], and request.on_done() was called
"""

from __future__ import annotations

import time
from typing import Any, Callable, Dict, List, Optional, Union

from pizarra.datum import FRAME_BYTES, FRAME_DEPTH, FRAME_ELEMENTS, elements
from pizarra.failure import Failure
from pizarra.writer import write

ENVELOPE_BYTES = 64
ENVELOPE_ELEMENTS = 4


class Request:
    """A request under way: done when `result` is no longer None, a value in a list or a Failure."""

    def __init__(self, body: str, repeatable: bool) -> None:
        self.body, self.repeatable = body, repeatable
        self.sent: Optional[float] = None
        self.result: Union[None, List[Any], Failure] = None
        self.on_done: Callable[[], None] = lambda: None

    @property
    def recalls(self) -> bool:
        return self.body.startswith("(recall ")


class Requests:
    # None goes before the board has answered those so far behind it: it remembers the answers of the last 256.
    MOST_AHEAD = 128
    MOST_PENDING = 4096

    def __init__(self, send: Callable[[str], bool]) -> None:
        self._send = send
        self._next = 1
        self._pending: Dict[int, Request] = {}

    def begin(self, body: Any, repeatable: bool) -> Request:
        if len(self._pending) >= self.MOST_PENDING:
            raise Failure("too-large", "too many requests to the board are under way")
        text = write(body, FRAME_DEPTH - 1)
        # An element takes a letter at least.
        many = len(text) > FRAME_ELEMENTS and elements(body) + ENVELOPE_ELEMENTS > FRAME_ELEMENTS
        if many or len(text.encode()) + ENVELOPE_BYTES > FRAME_BYTES:
            raise Failure("too-large", "the request does not fit one message of the board")
        number, self._next = self._next, self._next + 1
        request = self._pending[number] = Request(text, repeatable)
        return request

    def forget(self, request: Request) -> None:
        self._pending = {number: other for number, other in self._pending.items() if other is not request}

    def transmit(self, session: int, is_due: Callable[[Request], bool]) -> List[Request]:
        """Those that went."""
        first = next(iter(self._pending), 0)
        went: List[Request] = []
        for number, request in self._pending.items():
            if number >= first + self.MOST_AHEAD:
                break
            if is_due(request) and self._send(f"(request {session} {number} {request.body})"):
                request.sent = time.monotonic()
                went.append(request)
        return went

    def finish(self, number: int, result: Union[List[Any], Failure]) -> None:
        request = self._pending.pop(number, None)
        if request:
            request.result = result
            request.on_done()

    def fail(self, failure: Failure, concerned: Callable[[Request], bool]) -> None:
        for number, request in list(self._pending.items()):
            if concerned(request):
                self.finish(number, failure)

    def lose(self) -> None:
        """The board has forgotten who asked. What may not be done twice fails; the rest goes again."""
        self.fail(Failure("unreachable", "the board was lost: whether this happened is not known"),
                  lambda request: request.sent is not None and not request.repeatable)
        for request in self._pending.values():
            request.sent = None
