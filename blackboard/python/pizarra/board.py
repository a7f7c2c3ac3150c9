"""The board for a script that does one thing after another: every call waits for the board's answer.

    with Board("ipc:///tmp/cell/board.ipc", "script") as board:
        board.declare("(relation seen ((name string) (x number)) (key name))")
        board.tell('(seen "circle" 112.5)')                      # text, or data: [Symbol("seen"), "circle", 112.5]
        for change in board.watch("(seen ?name ?x)"):             # first what holds, then every change, in order
            print(change.added, change.removed)

One thread uses a Board. Every call lets it speak with the board; between calls use board.wait(seconds): a client that is
silent for ten seconds is forgotten, and its watches then begin again with a resynchronised change.
"""

from __future__ import annotations

import os
import time
from typing import Any, Callable, Iterable, List, Optional, TypeVar, Union

from pizarra import agent_patterns, board_calls
from pizarra.agent_patterns import Holder
from pizarra.answers import Answer, Answers, Fact, Recalled, query_of
from pizarra.board_calls import Call
from pizarra.failure import Failure
from pizarra.flow import Flow, Keep, Pause, Step, Until
from pizarra.relation import Relation
from pizarra.replica import Replicas
from pizarra.session import Session
from pizarra.session_requests import Request
from pizarra.steps import tell
from pizarra.watch import Stream, Watch

T = TypeVar("T")


class Board:
    def __init__(self, address: str, teller: str, key: Union[None, str, "os.PathLike[str]"] = None,
                 timeout: float = 5.0, waits: bool = True) -> None:
        self.session = Session(address, teller, key, waits)
        self.address, self.teller, self.timeout = address, self.session.teller, timeout
        self.revision = 0  # of the answers that ask() gave last
        self._replicas = Replicas(self.session)

    def close(self) -> None:
        self.session.close()

    def __enter__(self) -> "Board":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    # ---- facts

    def declare(self, *relations: Any) -> None:
        self._call(board_calls.declare(relations))

    def transact(self, steps: Iterable[Any], preconditions: Iterable[Any] = ()) -> int:
        """The revision it happened at."""
        return self._call(board_calls.transact(steps, preconditions))

    def tell(self, fact: Any, lease: int = 0, because: Iterable[int] = ()) -> int:
        return self.transact([tell(fact, lease, because)])

    def retract(self, pattern: Any) -> int:
        return self._call(agent_patterns.retraction(pattern))

    def ask(self, query: Any) -> Answers:
        answers = self._call(board_calls.ask(query))
        self.revision = answers.revision
        return answers

    def recall(self, query: Any) -> Recalled:
        """As ask(), and also from a board that may have been replaced: it says how old its answers may be."""
        return self._call(board_calls.recall(query))

    def take(self, pattern: Any, lease: int = 0) -> Optional[Fact]:
        """One fact that fits, which nobody else has then; it is put back when the lease ends before it was settled."""
        return self._call(board_calls.take(pattern, lease))

    def lease(self, seconds: float) -> int:
        return self._call(board_calls.lease(seconds))

    def renew(self, lease: int) -> None:
        self._call(board_calls.renew(lease))

    def keep(self, lease: int, every: float = 0.5) -> None:
        """Renews it so often from now on, whenever a call lets the board be spoken with; `every` 0: no longer."""
        self.session.leases.keep(lease, every)

    def release(self, lease: int) -> None:
        self._call(board_calls.release(lease))

    def watch(self, query: Any) -> Watch:
        watch = Watch(self, query_of(query))
        try:
            self.finish(watch.feed.request)
        except Failure:
            watch.close()
            raise
        return watch

    def stream(self, name: str) -> Stream:
        return Stream(self, name)

    def replicate(self, relation: Any) -> None:
        """Declares it, and holds its facts from then on: one pattern about it is answered from here (replica.py)."""
        self.declare(relation)
        replica = self._replicas.add(Relation(relation))
        try:
            self.wait_for(lambda: replica.whole or replica.ended, self.timeout, "the relation did not come in time")
            if replica.ended:
                raise replica.ended
        except Failure:
            self._replicas.remove(replica)
            raise

    def await_answer(self, query: Any, timeout: float) -> Answer:
        """The first answer that holds now or comes to hold in time."""
        deadline = time.monotonic() + timeout
        for answer in self.ask(query):
            return answer
        with self.watch(query) as watch:
            while True:
                change = watch.next(deadline - time.monotonic())
                if change.added:
                    return change.added[0]

    # ---- other agents (agent_patterns.py)

    def request(self, agent: str, operation: Any, timeout: float = 10.0) -> List[Any]:
        """QUERY: what the agent answers, without the `ok`."""
        return self.run(agent_patterns.request(self.teller, agent, operation, timeout))

    def send(self, agent: str, operation: Any, lease: int = 0) -> None:
        """SEND: nobody waits for what the agent answers."""
        self.run(agent_patterns.send(self.teller, agent, operation, lease))

    def pull(self, pattern: Any) -> Optional[Fact]:
        """The newest fact that fits."""
        return self.run(agent_patterns.pull(pattern))

    def event(self, pattern: Any, timeout: float, lease: int = 0) -> Fact:
        """EVENT: one fact that fits is taken, now or when it comes."""
        return self.run(agent_patterns.event(pattern, timeout, lease))

    def holder(self, client: str, role: str) -> Holder:
        """WIRING: who plays the role for the client at this moment."""
        return self.run(agent_patterns.holder(client, role))

    def server(self, role: str) -> str:
        """WIRING: the agent that plays the role for this client."""
        return self.run(agent_patterns.server(self.teller, role))

    def run(self, work: Union[Call[T], Flow[T]]) -> T:
        """A call, or a flow (flow.py)."""
        if isinstance(work, Call):
            return self._call(work)
        result: Any = None
        failure: Optional[Failure] = None
        while True:
            try:
                step = work.throw(failure) if failure else work.send(result)
            except StopIteration as end:
                return end.value  # type: ignore[no-any-return]
            try:
                result, failure = self._do(step), None
            except Failure as failed:
                result, failure = None, failed

    def _do(self, step: Step) -> Any:
        if isinstance(step, Pause):
            return self.wait(step.seconds)
        if isinstance(step, Keep):
            return self.keep(step.lease, step.every)
        if isinstance(step, Until):
            return self.await_answer(step.query, step.seconds)
        return self._call(step)

    # ---- time passes

    def wait(self, seconds: float) -> None:
        """Keeps in touch with the board meanwhile."""
        deadline = time.monotonic() + seconds
        while time.monotonic() < deadline:
            self.turn(min(0.05, max(0.0, deadline - time.monotonic())))

    def begin(self, body: Any, repeatable: bool) -> Request:
        """For those who have a loop of their own: begin, turn() often, look at the request's result."""
        return self.session.begin(body, repeatable)

    def turn(self, seconds: float = 0.0) -> None:
        """Receives what has come, waiting that long for it, and says what is due."""
        self.session.turn(seconds)

    def sockets(self) -> List[Any]:
        """To wait on, beside others; they change where several boards take over from each other."""
        return self.session.link.sockets()

    def _call(self, call: Call[T]) -> T:
        if call.is_question and self._replicas.holds(call.body[1]):
            self.turn()
            held = self._replicas.ask(call.body[1])
            if held is not None:
                return held  # type: ignore[return-value]
        value = self.finish(self.session.begin(call.body, call.repeatable))
        self.session.note_done(call.body)
        return call.understand(value)

    def finish(self, request: Request) -> Any:
        try:
            self.wait_for(lambda: request.result, self.timeout, None)
        except TimeoutError:
            raise self.session.overdue(request) from None
        if isinstance(request.result, Failure):
            raise request.result
        return request.result[0] if request.result else None

    def wait_for(self, ready: Callable[[], Optional[T]], timeout: Optional[float], late: Optional[str]) -> T:
        deadline = None if timeout is None else time.monotonic() + timeout
        while True:
            found = ready()
            if found:
                return found
            if deadline is not None and time.monotonic() >= deadline:
                raise Failure("timeout", late) if late else TimeoutError()
            self.turn(0.01)
