"""What a Board follows: the changes of a watch, and the images of a stream. Iterated, both wait for the next one.

    with board.watch("(seen ?name ?x)") as watch:
        first = watch.next(timeout=5)
        for change in watch: ...
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Iterator, Optional

from pizarra.answers import Change
from pizarra.failure import Failure
from pizarra.stream import Frame, StreamFeed
from pizarra.watch_feed import WatchFeed

if TYPE_CHECKING:
    from pizarra.board import Board


class Watch:
    """Iterated, it waits for each change: for ever, or until the `timeout` of next()."""

    def __init__(self, board: "Board", query: Any) -> None:
        self._board = board
        self.feed = WatchFeed(board.session, query)

    def poll(self) -> Optional[Change]:
        """The next change, or None where there is none yet."""
        return self.feed.poll()

    def next(self, timeout: Optional[float] = None) -> Change:
        return self._board.wait_for(self.feed.poll, timeout, "no change came in time")

    def __iter__(self) -> Iterator[Change]:
        while True:
            yield self.next()

    def close(self) -> None:
        self.feed.close()

    def __enter__(self) -> "Watch":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()


class Stream:
    """Follows an image stream: newest wins, and the next publisher under its name is gone on with."""

    def __init__(self, board: "Board", name: str) -> None:
        self._board = board
        self.feed = StreamFeed(board.session, name)
        try:
            board.finish(self.feed.request)
        except Failure:
            self.close()
            raise

    def poll(self) -> Optional[Frame]:
        """The newest frame, or None where there is none yet."""
        return self.feed.poll()

    def next(self, timeout: Optional[float] = None) -> Frame:
        return self._board.wait_for(self.feed.poll, timeout, "no frame came in time")

    def __iter__(self) -> Iterator[Frame]:
        while True:
            yield self.next()

    def close(self) -> None:
        self.feed.close()

    def __enter__(self) -> "Stream":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()
