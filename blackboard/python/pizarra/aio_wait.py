"""ZeroMQ's sockets in asyncio's loop, and waiting there for what news bring."""

from __future__ import annotations

import asyncio
import time
from typing import Callable, Optional, TypeVar

from pizarra.failure import Failure

T = TypeVar("T")


class Readable:
    """Calls when a ZeroMQ socket, or what its file stands for, may have something to read. That is said once for all that has come."""

    def __init__(self, loop: asyncio.AbstractEventLoop, call: Callable[[], object]) -> None:
        self._loop, self._call, self._file = loop, call, -1

    def begin(self, file: int) -> None:
        """The socket's zmq.FD, or another that tells its news once."""
        self._file = file
        self._loop.add_reader(self._file, self._call)
        self._loop.call_soon(self._call)

    def end(self) -> None:
        if self._file >= 0:
            self._loop.remove_reader(self._file)
        self._file = -1


async def wait(ready: Callable[[], Optional[T]], news: asyncio.Event, timeout: Optional[float], late: str,
                symbol: str = "timeout") -> T:
    """For what is ready, looked at whenever there are news."""
    deadline = None if timeout is None else time.monotonic() + timeout
    while True:
        news.clear()
        found = ready()
        if found:
            return found
        left = None if deadline is None else deadline - time.monotonic()
        if left is not None and left <= 0:
            raise Failure(symbol, late)
        try:
            await asyncio.wait_for(news.wait(), left)
        except asyncio.TimeoutError:
            continue  # a last look, and then it is late
