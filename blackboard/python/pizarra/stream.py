"""Images that a publisher has for whoever wants them: the newest wins, and a slow reader misses some.

    eyes = board.stream("vision-left")
    frame = eyes.next(timeout=5)                     # number, width, height, channels, pixels
    image = frame.array()                            # numpy: rows, columns (and blue, green, red)

A stream is announced as a fact, (stream NAME KIND PLACE). Python takes it over TCP.
"""

from __future__ import annotations

import struct
from typing import TYPE_CHECKING, Any, Callable, Optional

import zmq

from pizarra.datum import Symbol
from pizarra.failure import Failure
from pizarra.feed import WatchFeed
from pizarra.keys import Keys
from pizarra.link import connect
from pizarra.requests import Request
from pizarra.session import Session

if TYPE_CHECKING:
    from numpy import uint8
    from numpy.typing import NDArray

HEADER = struct.Struct("<5Q")


class Frame:
    """An image: `pixels` are bytes, row by row, blue, green and red of each where there are three channels."""

    def __init__(self, message: bytes) -> None:
        self.number, self.microseconds, self.width, self.height, self.channels = HEADER.unpack_from(message)
        self.pixels = message[HEADER.size:]
        if len(self.pixels) != self.width * self.height * self.channels:
            raise ValueError("not a frame")

    def array(self) -> "NDArray[uint8]":
        """As numpy has images: height x width, and x channels where there are several. It cannot be written to."""
        import numpy

        shape = (self.height, self.width, self.channels)[:2 if self.channels == 1 else 3]
        return numpy.frombuffer(self.pixels, dtype=numpy.uint8).reshape(shape)


class StreamFeed:
    """Follows the publisher that is announced under the name, and the next one after it."""

    def __init__(self, session: Session, name: str) -> None:
        self._session = session
        self._watch = WatchFeed(session, [Symbol("stream"), Symbol(name), Symbol("?kind"), Symbol("?place")])
        self._topic = name.encode() + b" "
        self.socket: Any = None
        # For a loop of somebody else's: the socket came, and goes.
        self.opened: Callable[[], None] = lambda: None
        self.closing: Callable[[], None] = lambda: None

    @property
    def request(self) -> Request:
        return self._watch.request

    def on_announcement(self, heard: Callable[[], None]) -> None:
        self._watch.on_news = heard

    def poll(self) -> Optional[Frame]:
        """The newest frame, or None where there is none yet."""
        change = self._watch.poll()
        if change and change.added:
            self._connect(change.added[-1].facts[0].datum[3])
        if self.socket is None or not self.socket.poll(0):
            return None
        try:
            return Frame(self.socket.recv()[len(self._topic):])
        except (ValueError, struct.error):
            return None  # not of a publisher of ours

    def _connect(self, place: Any) -> None:
        ways = [way[1:] for way in place if way[0] == Symbol("tcp") and len(way) == 5]
        if not ways:
            raise Failure("no-image", "the stream is to be had on its publisher's machine alone, without Python")
        self._disconnect()
        self.socket = self._session.context.socket(zmq.SUB)
        address, *keys = ways[0]
        connect(self.socket, address, Keys(*keys), ((zmq.LINGER, 0), (zmq.CONFLATE, 1), (zmq.SUBSCRIBE, self._topic)))
        self.opened()

    def _disconnect(self) -> None:
        if self.socket is not None:
            self.closing()
            self.socket.close(linger=0)
        self.socket = None

    def close(self) -> None:
        self._watch.close()
        self._disconnect()
