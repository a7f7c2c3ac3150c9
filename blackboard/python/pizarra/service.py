"""Requests to an agent, done and answered. `(request ID AGENT (OPERATION ...))` is taken under the agent's presence, and
settled in the transaction that tells `(reply ID (ok VALUE ...))` or `(reply ID (fail SYMBOL SENTENCE SUBJECT))`.

    service = Service(board, presence, handle)          # handle(request: Fact) is awaited for the list of values
    await service.serve()                               # for ever

A request is done once: an ID that was answered already is answered again the same way (the last 256 are remembered),
and a request that is told again while it is done is not begun twice. 64 are done at once. An agent that dies before it
replied leaves the request to its successor.
"""

from __future__ import annotations

import asyncio
import sys
import traceback
from collections import OrderedDict
from typing import Any, Awaitable, Callable, Dict, List, Optional, Set

from pizarra.aio import AsyncBoard
from pizarra.answers import Fact
from pizarra.datum import Symbol
from pizarra.failure import AWAY, Failure
from pizarra.presence import Presence
from pizarra.steps import settle, tell

Handler = Callable[[Fact], Awaitable[List[Any]]]


class Service:
    MOST_AT_ONCE, REMEMBERED, RETRY = 64, 256, 0.2

    def __init__(self, board: AsyncBoard, presence: Presence, handle: Handler) -> None:
        self._board, self._presence, self._handle = board, presence, handle
        self._room = asyncio.Semaphore(self.MOST_AT_ONCE)
        self._jobs: Set["asyncio.Task[None]"] = set()
        self._in_hand: Dict[str, int] = {}      # the fact that each was told as last
        self._replies: "OrderedDict[str, List[Any]]" = OrderedDict()

    async def serve(self) -> None:
        requests = [Symbol("request"), Symbol("?id"), Symbol(self._presence.name), Symbol("?operation")]
        while True:
            async with self._board.watch(requests) as watch:
                async for change in watch:
                    taken = [await self._take(answer.facts[0].datum) for answer in change.added]
                    if not all(taken):
                        break  # what was not reached is shown again by another watch

    async def leave(self, patience: float) -> None:
        """What is in hand is answered, if that does not take too long."""
        if self._jobs:
            await asyncio.wait(self._jobs, timeout=patience)
        for job in self._jobs:
            job.cancel()

    async def _take(self, request: Any) -> bool:
        """Who is not present takes nothing: where the lease has lapsed, the request waits for the next one."""
        await self._room.acquire()
        fact: Optional[Fact] = None
        try:
            lease = self._presence.lease
            fact = await self._board.take(request, lease)
        except Failure as failure:
            if failure.symbol not in ("unknown-lease", *AWAY):
                raise
            await asyncio.sleep(self.RETRY)
            return False
        finally:
            if fact is None:
                self._room.release()
        if fact is not None:
            job = asyncio.get_running_loop().create_task(self._answer(fact))
            self._jobs.add(job)
            job.add_done_callback(self._done)
        return True

    def _done(self, job: "asyncio.Task[None]") -> None:
        self._jobs.discard(job)
        self._room.release()
        if not job.cancelled() and job.exception():
            job.get_loop().call_exception_handler({"message": "a reply could not be given", "exception": job.exception()})

    async def _answer(self, request: Fact) -> None:
        number = str(request.datum[1])
        again = number in self._in_hand
        self._in_hand[number] = request.id
        if again:
            return  # its caller or the board was away: the newest fact is the one to settle
        try:
            result = self._replies.get(number) or await self._work_out(request)
            self._remember(number, result)
            if not await self._deliver(number, result):
                # Too large, or with a variable in it. The caller must not be left waiting.
                refused = failed(Failure("bad-reply", "the board refused the answer"))
                self._remember(number, refused)
                await self._deliver(number, refused)
        finally:
            del self._in_hand[number]

    async def _work_out(self, request: Fact) -> List[Any]:
        try:
            self._presence.contract.check(request.datum[3])
            return [Symbol("ok"), *await self._handle(request)]
        except Failure as failure:
            return failed(failure)
        except Exception as error:
            # The agent's own fault, which must not end it while others are served: its author is told where.
            traceback.print_exc(file=sys.stderr)
            return failed(Failure("broken", f"{type(error).__name__}: {error}", request.datum[3]))

    def _remember(self, number: str, result: List[Any]) -> None:
        self._replies[number] = result
        while len(self._replies) > self.REMEMBERED:
            self._replies.popitem(last=False)

    async def _deliver(self, number: str, result: List[Any]) -> bool:
        """False where the board refuses it. When the request is not held any more, its next taker answers it."""
        while True:
            cause = self._in_hand[number]
            try:
                await self._board.transact([tell([Symbol("reply"), Symbol(number), result], because=[cause]),
                                            settle(cause)])
                return True
            except Failure as failure:
                told_again = self._in_hand[number] != cause
                if failure.symbol == "precondition-failed" and not told_again:
                    return True
                if failure.symbol not in AWAY and not told_again:
                    return False
            await asyncio.sleep(self.RETRY)


def failed(failure: Failure) -> List[Any]:
    return [Symbol("fail"), Symbol(failure.symbol), failure.sentence, failure.subject]
