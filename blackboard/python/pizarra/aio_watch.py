"""What an AsyncBoard follows: the changes of a watch, and the images of a stream.

    async with board.watch("(seen ?name ?x)") as watch:       # refused, it is raised here
        first = await watch.next(timeout=5)
        async for change in watch: ...
"""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING, Any, AsyncIterator, Optional

from pizarra.answers import Change
from pizarra.aio_wait import Readable, wait
from pizarra.stream import Frame, StreamFeed
from pizarra.watch_feed import WatchFeed

if TYPE_CHECKING:
    from pizarra.aio import AsyncBoard


class AsyncWatch:
    """Iterated, it awaits each change. `async with` closes it behind."""

    def __init__(self, board: "AsyncBoard", query: Any) -> None:
        self._board = board
        self._news = asyncio.Event()
        self.feed = WatchFeed(board.session, query)
        self.feed.on_news = self._news.set

    def poll(self) -> Optional[Change]:
        """The next change, or None where there is none yet."""
        return self.feed.poll()

    async def next(self, timeout: Optional[float] = None) -> Change:
        return await wait(self.feed.poll, self._news, timeout, "no change came in time")

    async def __aiter__(self) -> AsyncIterator[Change]:
        while True:
            yield await self.next()

    async def begun(self) -> None:
        """The board has taken it; or the Failure why it does not."""
        await wait(lambda: self.feed.begun or self.feed.ended, self._news, self._board.timeout,
                    "the board does not answer", "unreachable")
        if self.feed.ended:
            raise self.feed.ended

    def close(self) -> None:
        self.feed.close()

    async def __aenter__(self) -> "AsyncWatch":
        try:
            await self.begun()
        except BaseException:
            self.close()
            raise
        return self

    async def __aexit__(self, *_: object) -> None:
        self.close()


class AsyncStream:
    """Follows an image stream: newest wins, and the next publisher under its name is gone on with."""

    def __init__(self, board: "AsyncBoard", name: str) -> None:
        self._news = asyncio.Event()
        self.feed = feed = StreamFeed(board.session, name)
        readable = Readable(asyncio.get_running_loop(), self._news.set)
        feed.on_announcement(self._news.set)
        feed.opened, feed.closing = readable.begin, readable.end

    def poll(self) -> Optional[Frame]:
        """The newest frame, or None where there is none yet."""
        return self.feed.poll()

    async def next(self, timeout: Optional[float] = None) -> Frame:
        return await wait(self.feed.poll, self._news, timeout, "no frame came in time")

    async def __aiter__(self) -> AsyncIterator[Frame]:
        while True:
            yield await self.next()

    def close(self) -> None:
        self.feed.close()

    async def __aenter__(self) -> "AsyncStream":
        return self

    async def __aexit__(self, *_: object) -> None:
        self.close()
