"""What a client and a board say to each other: who is there, requests and their replies, and what is watched.

    session = Session("ipc:///tmp/cell/board.ipc", "script", None)
    request = session.begin([Symbol("ask"), query], repeatable=True)
    while request.result is None: session.turn(0.01)           # a Failure, or the value in a list

It never waits by itself, but for as long as turn() is told to: Board (board.py) and AsyncBoard (aio.py) stand on it. A
request is sent again while it is not answered. When the board was lost, relations are declared again and feeds begin
again; a transaction or a take that was under way then fails, because nobody can say whether it happened.

Of several boards it may be that none can say whether it leads: they have no quorum of their log. Requests then wait, or
fail at once with `unavailable` where `waits` is False; `recall` is answered even so, by what may be old.
"""

from __future__ import annotations

import os
import time
from dataclasses import dataclass
from typing import Any, Callable, Dict, List, Optional, Union

import zmq

from pizarra.addresses import Addresses
from pizarra.datum import Symbol
from pizarra.failure import Failure, failure_from
from pizarra.keys import read_keys
from pizarra.leases import Leases
from pizarra.link import Link
from pizarra.reader import read_all
from pizarra.session_requests import Request, Requests
from pizarra.watch_feed import Feed
from pizarra.writer import check_teller, write


@dataclass
class Greetings:
    """The hellos to one board until it welcomes the client."""
    sent: float = -1e9  # when, the last
    is_of_the_first: bool = False  # whether the board seems to speak the first protocol
    newer: int = 0  # hellos of a later protocol, sent and not refused


class Session:
    PING, RESEND, GREET, SILENCE = 0.5, 1.0, 0.5, 2.0
    LISTENS = 0.1  # as often at least, who listens
    # Where another board may take over: it serves within half a second.
    PING_AMONG_OTHERS, SILENCE_AMONG_OTHERS = 0.1, 0.4
    PROTOCOL = 2  # of blackboard/wire/wire.hpp; a board of the first knows no hello that says one

    def __init__(self, address: str, teller: str, key: Union[None, str, "os.PathLike[str]"] = None,
                 waits: bool = True) -> None:
        if not isinstance(address, str) or not isinstance(teller, str):
            raise Failure("wrong-shape", "a board's address and the name of a teller are strings")
        check_teller(teller)
        self.address, self.teller = address, teller
        self.addresses = Addresses(address, time.monotonic())
        self.keys = None
        if key and not address.startswith("ipc://"):
            name, self.keys = read_keys(key)
            if teller != name and not teller.startswith(name + "/"):
                self.teller = f"{name}/{teller}"
        self.id = self._life = 0
        self.joined = False
        self._greetings = Greetings()
        self.in_doubt, self._waits = False, waits
        self._heard = self._pinged = -1e9
        self._listened = time.monotonic()
        self._declared: Dict[str, Any] = {}
        self.feeds: Dict[int, Feed] = {}
        self._next_feed = 1
        self.leases = Leases(lambda lease: self.begin([Symbol("renew"), lease], True))
        # Of a client that holds what it watches: the board is at this revision, and all up to there has come or has not.
        self.on_revision: Callable[[Optional[int], bool], None] = lambda revision, came: None
        # Another board, or one that has forgotten us.
        self.on_begun_again: Callable[[], None] = lambda: None
        self.context: Any = zmq.Context()
        try:
            self.link = Link(self.context, self.addresses.current, self.keys)
            self.requests = Requests(lambda text: self.link.send(text))
        except Failure:
            self.context.destroy(linger=0)
            raise

    def check_open(self) -> None:
        if self.context.closed:
            raise Failure("closed", "this board was closed", self.address)

    def close(self) -> None:
        if self.context.closed:
            return
        for feed in list(self.feeds.values()):
            feed.close()
        if self.joined:
            self.send([Symbol("bye"), self.id])
        self.link.close(linger=50)
        self.context.destroy(linger=50)
        self.requests.fail(Failure("closed", "this board was closed", self.address), lambda request: True)

    def begin(self, body: Any, repeatable: bool) -> Request:
        self.check_open()
        if self.in_doubt and not self._waits and body[0] != Symbol("recall"):
            raise self._unavailable(False)
        request = self.requests.begin(body, repeatable)
        if self.joined:
            self.requests.transmit(self.id, lambda other: other is request)
        return request

    def forget(self, request: Request) -> None:
        self.requests.forget(request)

    def overdue(self, request: Request) -> Failure:
        """What a request fails with that was not answered in time."""
        self.forget(request)
        if self.in_doubt:
            return self._unavailable(request.sent is not None)
        return Failure("unreachable", "the board does not answer", self.address)

    def _unavailable(self, sent: bool) -> Failure:
        done = "whether this happened is not known" if sent else "this was not done"
        return Failure("unavailable", f"the board has no quorum of its log: {done}", self.address)

    def note_done(self, body: List[Any]) -> None:
        """What was declared is declared again when the board was lost."""
        if body[0] == Symbol("declare"):
            self._declared.update((str(form[1]), form) for form in body[1:])

    def next_feed(self) -> int:
        number, self._next_feed = self._next_feed, self._next_feed + 1
        return number

    # ---- time passes

    def turn(self, seconds: float = 0.0) -> None:
        """Receives what has come, waiting that long for it, and says what is due."""
        self.check_open()
        # A client that does not listen cannot say that the board is silent.
        self._heard += max(0.0, time.monotonic() - self._listened - self.LISTENS)
        self._tick()
        if seconds > 0:
            self.link.wait(seconds)
        for text in self.link.receive():
            messages = read_all(text)
            # One that does not know whether it leads gives no sign of life.
            if messages and messages[0][0] != Symbol("unavailable"):
                self._heard = time.monotonic()
            for message in messages:
                self._receive(message)
        self._tick()
        self._listened = time.monotonic()

    def send(self, message: List[Any]) -> bool:
        self.check_open()
        return self.link.send(write(message))

    def _tick(self) -> None:
        now = time.monotonic()
        if self.link.was_refused():
            self._refused()
        others = self.addresses.has_others
        if self.joined and self._heard + (self.SILENCE_AMONG_OTHERS if others else self.SILENCE) <= now:
            self.joined = False
            self._greetings = Greetings()
            self.addresses.lost(now)
        if not self.joined:
            self._greet(now)
            return
        every = self.PING_AMONG_OTHERS if others else self.PING
        if self._pinged + every <= now and self.send([Symbol("ping"), self.id]):
            self._pinged = now
            for feed in self.feeds.values():
                feed.acknowledge()  # what could not be said before
        self.leases.renew_due(now)
        self.requests.transmit(self.id, lambda request: request.sent is None or request.sent + self.RESEND <= now)

    def _greet(self, now: float) -> None:
        if self.addresses.is_time_for_the_next(now):
            self.addresses.go_on(now)
            self._greetings = Greetings()
            self.link.begin_again(self.addresses.current)
        more = [] if self._greetings.is_of_the_first else [self.PROTOCOL, Symbol("doubts")]
        hello = [Symbol("hello"), self.teller, self.id, *more]
        if self._greetings.sent + self.GREET <= now and self.send(hello):
            self._greetings.sent = now
            self._greetings.newer += not self._greetings.is_of_the_first

    def _refused(self) -> None:
        self.joined = False
        self.requests.fail(Failure("not-permitted", "the board does not accept this key" if self.keys else
                           "the board asks for a key at this address"), lambda request: True)
        self.link.begin_again()

    # ---- what the board says

    def _receive(self, message: Any) -> None:
        kind = str(message[0])
        if kind == "reply":
            self._replied(message)
        elif kind == "unavailable":
            self._be_in_doubt()
        elif kind == "change":
            self._changed(message)
        elif kind == "welcome" and not self.joined:
            self._welcomed(*message[1:3])
        elif kind == "goodbye" or kind == "unknown-session" and message[1] == self.id:
            self.joined = False
            self._greetings = Greetings()
        elif kind == "refused":
            failure = failure_from(message[1])
            if not self.joined and failure.symbol == "bad-frame" and self._greetings.newer > 0:
                self._greetings.newer -= 1  # of which two may be under way
                if not self._greetings.is_of_the_first:
                    self._greetings.is_of_the_first, self._greetings.sent = True, -1e9
                return
            # Of a hello, on which everything waits; or of what the board could not read, any of what was sent to it.
            self.requests.fail(failure, lambda request: not self.joined or request.sent is not None)
        elif kind == "watch-failed" and message[1] in self.feeds:
            self.feeds[message[1]].end(failure_from(message[2]))

    def _replied(self, message: Any) -> None:
        self.on_revision(*(message[3], message[4] == Symbol("yes")) if len(message) > 4 else (None, False))
        result = message[2]
        self.requests.finish(message[1], [result[1]] if result[0] == Symbol("ok") else failure_from(result))

    def _changed(self, message: Any) -> None:
        feed = self.feeds.get(message[1])
        if feed:
            feed.receive(message[2], message[3:])
        else:
            self.send([Symbol("unwatch"), self.id, message[1]])

    def _be_in_doubt(self) -> None:
        self.in_doubt = True
        if self.joined:
            return
        # A board that leads is asked anew.
        for request in self.requests.transmit(self.id, lambda request: request.recalls):
            request.sent = None
        if not self._waits:
            self.requests.fail(self._unavailable(False), lambda request: request.sent is None and not request.recalls)

    def _welcomed(self, session: int, life: int) -> None:
        self.joined, self.in_doubt = True, False
        self.addresses.found()
        same_session, same_life = session == self.id, life == self._life
        self.id, self._life = session, life
        if not same_session:
            self.requests.lose()
        if not (same_session and same_life):
            self.on_begun_again()
            if self._declared:
                self.begin([Symbol("declare"), *self._declared.values()], True)
            for feed in list(self.feeds.values()):
                if feed.request.result is not None:
                    feed.begin_again()
        self.requests.transmit(self.id, lambda request: True)
