"""What a board says of one watched query: changes, numbered from 1, acknowledged as they are read.

A feed begins again, under a new number, when a change is missing or the board was lost. WatchFeed keeps what came until
it is read; a replica (replica.py) keeps what holds.
"""

from __future__ import annotations

from collections import deque
from typing import TYPE_CHECKING, Any, Callable, Deque, Dict, List, Optional, Tuple

from pizarra.answers import Answer, Change, answers_from
from pizarra.datum import Symbol
from pizarra.failure import Failure

if TYPE_CHECKING:
    from pizarra.session import Session


class Feed:
    # Where changes come one by one, an acknowledgement of each would wake the board as often as the changes do.
    ACKNOWLEDGE_AFTER = 8

    def __init__(self, session: "Session", query: List[Any], *held: Symbol) -> None:
        self.session, self.query, self._held = session, query, held
        self.begun = False  # the board has taken it, or not
        self.ended: Optional[Failure] = None
        self.on_news: Callable[[], None] = lambda: None
        self._enrol()

    def _enrol(self) -> None:
        self.id = self.session.next_feed()
        self._expected, self._read, self._acknowledged = 1, 0, 0
        self.request = self.session.begin([Symbol("watch"), self.id, self.query, *self._held], True)
        self.request.on_done = self._answered
        self.session.feeds[self.id] = self

    def _answered(self) -> None:
        if isinstance(self.request.result, Failure):
            self.end(self.request.result)
        self.begun = True
        self.on_news()

    def begin_again(self) -> None:
        if not self.ended:
            self._leave()
            self._enrol()

    def _leave(self) -> None:
        self.session.feeds.pop(self.id, None)
        self.session.forget(self.request)
        self.session.send([Symbol("unwatch"), self.session.id, self.id])

    def close(self) -> None:
        if self.id in self.session.feeds:
            self._leave()

    def end(self, failure: Failure) -> None:
        """Nothing more will come."""
        self.ended = failure
        self.on_news()

    def receive(self, sequence: int, form: Any) -> None:
        revision, kind = form[0], str(form[1])
        if sequence < self._expected:
            return
        if sequence > self._expected and kind not in ("yes", "first"):
            self.begin_again()
            return
        self._expected = sequence + 1
        self.come(sequence, revision, kind, form[2], form[3])
        self.on_news()

    def come(self, sequence: int, revision: int, kind: str, added: Any, removed: Any) -> None:
        raise NotImplementedError

    def read_up_to(self, sequence: int, say_so: bool) -> None:
        self._read = max(self._read, sequence)
        if say_so or self._read - self._acknowledged >= self.ACKNOWLEDGE_AFTER:
            self.acknowledge()

    def acknowledge(self) -> None:
        owed = self._read > self._acknowledged
        if owed and self.session.send([Symbol("ack"), self.session.id, self.id, self._read]):
            self._acknowledged = self._read


class WatchFeed(Feed):
    MOST_UNREAD = 256  # more than a board sends unacknowledged

    def __init__(self, session: "Session", query: List[Any]) -> None:
        self._unread: Deque[Tuple[int, Change]] = deque()
        self._parts: Dict[Tuple[int, ...], Answer] = {}
        super().__init__(session, query)

    def begin_again(self) -> None:
        # They are of a number that needs no acknowledgement any more.
        self._unread = deque((0, change) for _, change in self._unread)
        super().begin_again()

    def come(self, sequence: int, revision: int, kind: str, added: Any, removed: Any) -> None:
        came, went = answers_from(self.query, added), answers_from(self.query, removed)
        if kind in ("no", "yes"):
            self._keep(sequence, Change(revision, kind == "yes", came, went))
            return
        # What holds is more than a message holds: parts, the first of which voids what was known.
        if kind == "first":
            self._parts = {}
        for answer in went:
            self._parts.pop(_ids(answer), None)
        self._parts.update((_ids(answer), answer) for answer in came)
        if kind == "last":
            whole = [answer for _, answer in sorted(self._parts.items())]
            self._keep(sequence, Change(revision, True, whole, []))
            self._parts = {}
        else:
            self.read_up_to(sequence, True)

    def _keep(self, sequence: int, change: Change) -> None:
        if change.resynchronised and len(self._unread) >= self.MOST_UNREAD:
            self._unread.clear()  # void, and nobody reads
        self._unread.append((sequence, change))

    def poll(self) -> Optional[Change]:
        """The next change, or None where there is none yet."""
        self.session.check_open()
        if not self._unread:
            if self.ended:
                raise self.ended
            return None
        sequence, change = self._unread.popleft()
        if sequence:
            self.read_up_to(sequence, not self._unread)
        return change


def _ids(answer: Answer) -> Tuple[int, ...]:
    return tuple(fact.id for fact in answer.facts)
