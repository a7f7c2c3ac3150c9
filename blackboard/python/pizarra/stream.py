"""Images that a publisher has for whoever wants them: the newest wins, and a slow reader misses some.

    eyes = board.stream("vision-left")
    frame = eyes.next(timeout=5)                     # number, width, height, channels, pixels
    image = frame.array()                            # numpy: rows, columns (and blue, green, red)

A stream is announced as a fact, (stream NAME KIND PLACE). On its publisher's machine it is taken from memory that both
share, elsewhere over TCP.
"""

from __future__ import annotations

import struct
from typing import TYPE_CHECKING, Any, Callable, Optional, Union

import zmq

from pizarra.datum import Symbol
from pizarra.failure import Failure
from pizarra.keys import Keys
from pizarra.link import connect
from pizarra.ring import RingGuest
from pizarra.session import Session
from pizarra.session_requests import Request
from pizarra.watch_feed import WatchFeed

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


class RemoteGuest:
    """Of a publisher anywhere, at the address that it announced."""

    def __init__(self, context: Any, way: Any, stream: str) -> None:
        address, *keys = way
        self._topic = stream.encode() + b" "
        self._socket = context.socket(zmq.SUB)
        connect(self._socket, address, Keys(*keys),
                ((zmq.LINGER, 0), (zmq.CONFLATE, 1), (zmq.SUBSCRIBE, self._topic)))

    @property
    def file(self) -> int:
        number: int = self._socket.getsockopt(zmq.FD)
        return number

    def poll(self) -> Optional[bytes]:
        if not self._socket.poll(0):
            return None
        message: bytes = self._socket.recv()
        return message[len(self._topic):]

    def close(self) -> None:
        self._socket.close(linger=0)


class StreamFeed:
    """Follows the publisher that is announced under the name, and the next one after it."""

    def __init__(self, session: Session, name: str) -> None:
        self._session, self._name = session, name
        self._watch = WatchFeed(session, [Symbol("stream"), Symbol(name), Symbol("?kind"), Symbol("?place")])
        self._guest: Optional[Union[RingGuest, RemoteGuest]] = None
        # For a loop of somebody else's: there is a file that says when to look, and it goes.
        self.opened: Callable[[int], None] = lambda file: None
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
            self._come(change.added[-1].facts[0].datum[3])
        message = self._guest.poll() if self._guest else None
        try:
            return Frame(message) if message else None
        except (ValueError, struct.error):
            return None  # not of a publisher of ours

    def _come(self, place: Any) -> None:
        self._leave()
        for way, *where in place:
            if way == Symbol("door") and len(where) == 1:
                try:
                    self._guest = RingGuest(str(where[0]), self._name)
                    break
                except OSError:
                    continue  # on another machine, or of another user
            if way == Symbol("tcp") and len(where) == 4:
                self._guest = RemoteGuest(self._session.context, where, self._name)
                break
        if self._guest is None:
            raise Failure("no-image", "the stream is to be had on its publisher's machine alone, by its user")
        self.opened(self._guest.file)

    def _leave(self) -> None:
        if self._guest is not None:
            self.closing()
            self._guest.close()
        self._guest = None

    def close(self) -> None:
        self._watch.close()
        self._leave()
