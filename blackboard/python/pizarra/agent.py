"""An agent: it is present, has a contract, does what it is asked, and follows facts. It goes on when the board is started
again.

    agent = Agent("lamp", posts=["(relation lamp ((colour symbol)) (key))"])

    @agent.operation("(blink (times integer))")
    async def blink(times):                              # what it returns is answered: nothing, a value, a tuple of values
        if times > 9: raise Failure("too-often", "a lamp blinks at most nine times", times)

    @agent.watches("(arm ?robot moving ?action)")
    async def moving(change):                            # a Change, one after another
        await agent.tell([Symbol("lamp"), Symbol("red")])

    if __name__ == "__main__":
        agent.main()                                     # lamp.py BOARD-ADDRESS [--key FILE] [--name NAME]

Operations may run side by side; each watch has one change in hand. Both may be plain functions where they need not
await anything. `agent.board` is the AsyncBoard.
"""

from __future__ import annotations

import argparse
import asyncio
import contextvars
import inspect
import signal
import sys
from typing import Any, Awaitable, Callable, Dict, Iterable, List, Optional, Tuple, TypeVar, Union

from pizarra.agent_patterns import are_declared
from pizarra.aio import AsyncBoard
from pizarra.answers import Change, Fact
from pizarra.contract import Contract, Operation
from pizarra.datum import Symbol
from pizarra.failure import AWAY, Failure
from pizarra.presence import Presence
from pizarra.service import Service

Function = TypeVar("Function", bound=Callable[..., Any])


class Agent:
    BEAT, RETRY, PATIENCE = 0.25, 0.5, 2.0

    def __init__(self, name: str, kind: Optional[str] = None, posts: Iterable[Any] = (), reads: Iterable[Any] = (),
                 configures: Iterable[Any] = (), monitors: Iterable[Any] = (), host: Optional[str] = None,
                 context: Optional[str] = None, takes: Iterable[Any] = ()) -> None:
        """`kind` is as the name where it is not said. What it reads is a relation's name, or a whole relation, which is
        declared then: so it need not wait for who posts it. `context` is where it is bound (docs/facts/agents.md, Names)."""
        self.name, self.kind, self.host, self.context = name, kind or name, host, context
        self._parts = (list(posts), list(reads), list(configures), list(monitors), list(takes))
        self._operations: Dict[str, Tuple[Operation, Callable[..., Any]]] = {}
        self._watches: List[Tuple[Any, Callable[..., Any]]] = []
        self._beats: List[Tuple[float, Callable[..., Any]]] = []
        self._comings: List[Callable[..., Any]] = []
        self._request: "contextvars.ContextVar[Fact]" = contextvars.ContextVar("request")
        self._board: Optional[AsyncBoard] = None
        self._presence: Optional[Presence] = None

    # ---- what it does

    def operation(self, form: Any) -> Callable[[Function], Function]:
        """Offers (NAME (ARGUMENT TYPE) ...): the function has the arguments in their order."""
        offered = Operation(form)

        def keep(function: Function) -> Function:
            self._operations[offered.name] = (offered, function)
            return function
        return keep

    def watches(self, query: Any) -> Callable[[Function], Function]:
        """The function has each Change: first all that holds, resynchronised, and again where some may be missing."""
        def keep(function: Function) -> Function:
            self._watches.append((query, function))
            return function
        return keep

    def every(self, seconds: float) -> Callable[[Function], Function]:
        def keep(function: Function) -> Function:
            self._beats.append((seconds, function))
            return function
        return keep

    def comes(self, function: Function) -> Function:
        """Whenever its presence begins, also after the board was started again: to tell what stands."""
        self._comings.append(function)
        return function

    # ---- what it has, while it runs

    @property
    def board(self) -> AsyncBoard:
        if self._board is None:
            raise Failure("closed", f"{self.name} does not run")
        return self._board

    @property
    def presence(self) -> Presence:
        if self._presence is None:
            raise Failure("closed", f"{self.name} does not run")
        return self._presence

    @property
    def request(self) -> Fact:
        """What is done now: its teller is who asked. In an operation alone."""
        return self._request.get()

    @property
    def contract(self) -> Contract:
        return Contract(self.kind, [offered for offered, _ in self._operations.values()], *self._parts)

    async def tell(self, fact: Any, because: Iterable[int] = ()) -> int:
        """Under the agent's presence, and as soon as there is one: it goes with the agent."""
        because = list(because)
        while True:
            try:
                return await self.board.tell(fact, self.presence.lease, because)
            except Failure as failure:
                if failure.symbol not in (*AWAY, "unknown-lease"):
                    raise
            await asyncio.sleep(self.RETRY)

    # ---- its life

    def main(self) -> None:
        parser = argparse.ArgumentParser(description=f"The agent {self.name}, until it is ended by Ctrl-C or SIGTERM.")
        parser.add_argument("board", metavar="BOARD-ADDRESS", help="as `pizarra ps` shows it")
        parser.add_argument("--name", default=self.name, help=f"what it is called on the board; {self.name} otherwise")
        parser.add_argument("--key", metavar="FILE", help="its secret, for a board that asks for keys")
        choices = parser.parse_args()
        self.name = choices.name
        try:
            asyncio.run(self._run_until_signal(choices.board, choices.key))
        except Failure as failure:
            sys.exit(f"{self.name}: {failure}")

    def run(self, address: str, key: Optional[str] = None) -> None:
        """Until SIGTERM or Ctrl-C."""
        asyncio.run(self._run_until_signal(address, key))

    async def _run_until_signal(self, address: str, key: Optional[str]) -> None:
        serving = asyncio.ensure_future(self.serve(address, key))
        asyncio.get_running_loop().call_later(2 * self.PATIENCE, self._say_what_it_waits_for, address)
        for number in (signal.SIGINT, signal.SIGTERM):
            asyncio.get_running_loop().add_signal_handler(number, serving.cancel)
        try:
            await serving
        except asyncio.CancelledError:
            pass  # as it was told to

    async def serve(self, address: str, key: Optional[str] = None) -> None:
        """Until it is cancelled, or something fails that it cannot mend. In an orderly way its name is free at once."""
        async with AsyncBoard(address, self.name, key) as board:
            self._board = board
            presence = self._presence = Presence(self.name, self.contract, self.host, self.context)
            service = Service(board, presence, self._do)
            began = asyncio.Event()
            presence.on_lease = began.set
            await board.run(presence.come())
            try:
                await _all(self._keep(presence), service.serve(), self._come(began),
                           *(self._follow(query, function) for query, function in self._watches),
                           *(self._beat(seconds, function) for seconds, function in self._beats))
            finally:
                await service.leave(self.PATIENCE)
                await board.run(presence.leave())
                self._board = self._presence = None

    def _say_what_it_waits_for(self, address: str) -> None:
        if self._presence is None or self._presence.lease:
            return
        if self._presence.is_taken:
            reason = "another agent has this name: waiting until it is gone"
        else:
            reason = f"no board answers at {address} yet: waiting for it"
        print(f"{self.name}: {reason}", file=sys.stderr, flush=True)

    async def _keep(self, presence: Presence) -> None:
        while True:
            await asyncio.sleep(self.BEAT)
            await self.board.run(presence.keep())

    async def _come(self, began: asyncio.Event) -> None:
        while True:
            await began.wait()
            began.clear()
            try:
                for function in self._comings:
                    await _called(function)
            except Failure as failure:
                if failure.symbol not in (*AWAY, "unknown-lease"):
                    raise
                await asyncio.sleep(self.RETRY)
                began.set()

    async def _follow(self, query: Any, function: Callable[[Change], Any]) -> None:
        """Of relations that others post, once these are declared. Where the board was away from what the function did, it
        has all that holds once more."""
        while True:
            while not await self.board.run(are_declared(query)):
                await asyncio.sleep(self.RETRY)
            watch = self.board.watch(query)
            try:
                while True:
                    await _called(function, await watch.next())
            except Failure as failure:
                forgotten = failure is watch.feed.ended and failure.symbol == "undeclared-relation"
                if failure.symbol not in AWAY and not forgotten:
                    raise
            finally:
                watch.close()
            await asyncio.sleep(self.RETRY)

    async def _beat(self, seconds: float, function: Callable[[], Any]) -> None:
        while True:
            await asyncio.sleep(seconds)
            try:
                await _called(function)
            except Failure as failure:
                if failure.symbol not in (*AWAY, "unknown-lease"):
                    raise  # these pass with time, and so does the beat

    async def _do(self, request: Fact) -> List[Any]:
        self._request.set(request)
        name, *arguments = request.datum[3]
        result = await _called(self._operations[str(name)][1], *arguments)
        if result is None:
            return []
        return list(result) if isinstance(result, tuple) else [result]


async def _called(function: Callable[..., Union[Any, Awaitable[Any]]], *arguments: Any) -> Any:
    result = function(*arguments)
    return await result if inspect.isawaitable(result) else result


async def _all(*work: Any) -> None:
    """Side by side; when one fails, the others are cancelled and it is raised."""
    tasks = [asyncio.ensure_future(each) for each in work]
    try:
        await asyncio.gather(*tasks)
    finally:
        for task in tasks:
            task.cancel()
        await asyncio.gather(*tasks, return_exceptions=True)
