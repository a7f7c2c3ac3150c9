"""The board for asyncio: each call is awaited, and any number may be under way at once.

    async with AsyncBoard("ipc:///tmp/cell/board.ipc", "script") as board:
        await board.declare("(relation seen ((name string) (x number)) (key name))")
        await asyncio.gather(*(board.tell([Symbol("seen"), str(n), n]) for n in range(100)))
        async for change in board.watch("(seen ?name ?x)"):       # first what holds, then every change, in order
            print(change.added, change.removed)

It has what Board (board.py) has. It belongs to one loop: it begins to speak inside `async with`, and ends with it.
"""

from __future__ import annotations

import asyncio
import os
import time
from typing import Any, Iterable, List, Optional, TypeVar, Union

from pizarra import agent_patterns, board_calls
from pizarra.agent_patterns import Holder
from pizarra.aio_watch import AsyncStream, AsyncWatch
from pizarra.answers import Answer, Answers, Fact, Recalled, query_of
from pizarra.board_calls import Call
from pizarra.failure import Failure
from pizarra.flow import Flow, Keep, Pause, Step, Until
from pizarra.aio_wait import Readable, wait
from pizarra.relation import Relation
from pizarra.replica import Replicas
from pizarra.session import Session
from pizarra.session_requests import Request
from pizarra.steps import tell

T = TypeVar("T")
TICK = 0.05  # how often what is due is looked for


class AsyncBoard:
    def __init__(self, address: str, teller: str, key: Union[None, str, "os.PathLike[str]"] = None,
                 timeout: float = 5.0, waits: bool = True) -> None:
        self.session = Session(address, teller, key, waits)
        self.address, self.teller, self.timeout = address, self.session.teller, timeout
        self._replicas = Replicas(self.session)
        self._ticking: Optional["asyncio.Task[None]"] = None
        self._look_is_due = False

    async def __aenter__(self) -> "AsyncBoard":
        self._loop = asyncio.get_running_loop()
        link = self.session.link
        readable = Readable(self._loop, self._turn)
        link.opened, link.closing = (lambda: readable.begin(link.file)), readable.end
        link.sent = self._look_soon
        readable.begin(link.file)
        self._ticking = self._loop.create_task(self._tick())
        self._ticking.add_done_callback(self._ticked)
        return self

    async def __aexit__(self, *_: object) -> None:
        if self._ticking:
            self._ticking.cancel()
        self.session.close()

    async def _tick(self) -> None:
        while True:
            self._turn()
            await asyncio.sleep(TICK)

    def _ticked(self, ticking: "asyncio.Task[None]") -> None:
        """Over, or broken: who waits is told."""
        self.session.close()
        if not ticking.cancelled() and ticking.exception():
            self._loop.call_exception_handler({"message": "a board's messages broke its client",
                                               "exception": ticking.exception()})

    def _turn(self) -> None:
        if not self.session.context.closed:
            self.session.turn()

    def _look_soon(self) -> None:
        if not self._look_is_due:
            self._look_is_due = True
            self._loop.call_soon(self._look)

    def _look(self) -> None:
        self._look_is_due = False
        if not self.session.context.closed and self.session.link.has_more():
            self._turn()

    # ---- facts

    async def declare(self, *relations: Any) -> None:
        await self._call(board_calls.declare(relations))

    async def transact(self, steps: Iterable[Any], preconditions: Iterable[Any] = ()) -> int:
        """The revision it happened at."""
        return await self._call(board_calls.transact(steps, preconditions))

    async def tell(self, fact: Any, lease: int = 0, because: Iterable[int] = ()) -> int:
        return await self.transact([tell(fact, lease, because)])

    async def retract(self, pattern: Any) -> int:
        return await self._call(agent_patterns.retraction(pattern))

    async def ask(self, query: Any) -> Answers:
        return await self._call(board_calls.ask(query))

    async def recall(self, query: Any) -> Recalled:
        """As ask(), and also from a board that may have been replaced: it says how old its answers may be."""
        return await self._call(board_calls.recall(query))

    async def take(self, pattern: Any, lease: int = 0) -> Optional[Fact]:
        """One fact that fits, which nobody else has then; it is put back when the lease ends before it was settled."""
        return await self._call(board_calls.take(pattern, lease))

    async def lease(self, seconds: float) -> int:
        return await self._call(board_calls.lease(seconds))

    async def renew(self, lease: int) -> None:
        await self._call(board_calls.renew(lease))

    def keep(self, lease: int, every: float = 0.5) -> None:
        """Renews it so often from now on, until the board ends; `every` 0: no longer."""
        self.session.leases.keep(lease, every)

    async def release(self, lease: int) -> None:
        await self._call(board_calls.release(lease))

    def watch(self, query: Any) -> AsyncWatch:
        """A refusal is raised where its changes are awaited, or by `async with`."""
        return AsyncWatch(self, query_of(query))

    def stream(self, name: str) -> AsyncStream:
        return AsyncStream(self, name)

    async def replicate(self, relation: Any) -> None:
        """Declares it, and holds its facts from then on: one pattern about it is answered from here (replica.py)."""
        await self.declare(relation)
        replica = self._replicas.add(Relation(relation))
        news = asyncio.Event()
        replica.on_news = news.set
        try:
            await wait(lambda: replica.whole or replica.ended, news, self.timeout, "the relation did not come in time")
            if replica.ended:
                raise replica.ended
        except Failure:
            self._replicas.remove(replica)
            raise

    async def await_answer(self, query: Any, timeout: float) -> Answer:
        """The first answer that holds now or comes to hold in time."""
        deadline = time.monotonic() + timeout
        for answer in await self.ask(query):
            return answer
        async with self.watch(query) as watch:
            while True:
                change = await watch.next(deadline - time.monotonic())
                if change.added:
                    return change.added[0]

    # ---- other agents (agent_patterns.py)

    async def request(self, agent: str, operation: Any, timeout: float = 10.0) -> List[Any]:
        """QUERY: what the agent answers, without the `ok`."""
        return await self.run(agent_patterns.request(self.teller, agent, operation, timeout))

    async def send(self, agent: str, operation: Any, lease: int = 0) -> None:
        """SEND: nobody waits for what the agent answers."""
        await self.run(agent_patterns.send(self.teller, agent, operation, lease))

    async def pull(self, pattern: Any) -> Optional[Fact]:
        """The newest fact that fits."""
        return await self.run(agent_patterns.pull(pattern))

    async def event(self, pattern: Any, timeout: float, lease: int = 0) -> Fact:
        """EVENT: one fact that fits is taken, now or when it comes."""
        return await self.run(agent_patterns.event(pattern, timeout, lease))

    async def holder(self, client: str, role: str) -> Holder:
        """WIRING: who plays the role for the client at this moment."""
        return await self.run(agent_patterns.holder(client, role))

    async def server(self, role: str) -> str:
        """WIRING: the agent that plays the role for this client."""
        return await self.run(agent_patterns.server(self.teller, role))

    async def run(self, work: Union[Call[T], Flow[T]]) -> T:
        """A call, or a flow (flow.py)."""
        if isinstance(work, Call):
            return await self._call(work)
        result: Any = None
        failure: Optional[Failure] = None
        while True:
            try:
                step = work.throw(failure) if failure else work.send(result)
            except StopIteration as end:
                return end.value  # type: ignore[no-any-return]
            try:
                result, failure = await self._do(step), None
            except Failure as failed:
                result, failure = None, failed

    async def _do(self, step: Step) -> Any:
        if isinstance(step, Pause):
            return await asyncio.sleep(step.seconds)
        if isinstance(step, Keep):
            return self.keep(step.lease, step.every)
        if isinstance(step, Until):
            return await self.await_answer(step.query, step.seconds)
        return await self._call(step)

    async def _call(self, call: Call[T]) -> T:
        if call.is_question and self._replicas.holds(call.body[1]):
            self._turn()
            held = self._replicas.ask(call.body[1])
            if held is not None:
                return held  # type: ignore[return-value]
        value = await self._finish(self.session.begin(call.body, call.repeatable))
        self.session.note_done(call.body)
        return call.understand(value)

    async def _finish(self, request: Request) -> Any:
        if not self._ticking:
            raise Failure("closed", "an AsyncBoard is used inside `async with`", self.address)
        done = self._loop.create_future()
        request.on_done = lambda: None if done.done() else done.set_result(None)
        in_time = self._loop.call_later(self.timeout, request.on_done)
        try:
            if request.result is None:
                await done
        except asyncio.CancelledError:
            self.session.forget(request)
            raise
        finally:
            in_time.cancel()
        if request.result is None:
            raise self.session.overdue(request)
        if isinstance(request.result, Failure):
            raise request.result
        return request.result[0] if request.result else None
