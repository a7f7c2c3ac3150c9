"""The way to a board: a ZeroMQ socket that is connected, and connected again when session.py or addresses.py say so.

    link = Link(context, "tcp://bench:7943", keys)
    link.send("(ping 7)")
    for text in link.receive(): ...

A loop of somebody else's waits on `sockets()`. `opened` and `closing` are called whenever these change, and `sent` when
something was sent, which may take the news of what has come from a socket's file.
"""

from __future__ import annotations

from typing import Any, Callable, Iterator, List, Optional, Tuple

import zmq

from pizarra.failure import Failure
from pizarra.keys import Keys

# A peer that is silent for six seconds is gone: told by TCP, for ZeroMQ's heartbeats end a program whose peer goes at
# the wrong moment (blackboard/wire/half_open.hpp).
_LET_GO_WHEN_HALF_OPEN = ((zmq.TCP_KEEPALIVE, 1), (zmq.TCP_KEEPALIVE_IDLE, 2), (zmq.TCP_KEEPALIVE_INTVL, 2),
                          (zmq.TCP_KEEPALIVE_CNT, 3), (zmq.TCP_MAXRT, 6000))
_READABLE = int(zmq.POLLIN)  # as a flag of an enumeration it takes as long as the look itself
_AS_A_CLIENT = ((zmq.LINGER, 50), (zmq.IMMEDIATE, 1), (zmq.RECONNECT_IVL, 50), (zmq.RECONNECT_IVL_MAX, 1000))


def connect(socket: Any, address: str, keys: Optional[Keys], options: Tuple[Tuple[int, Any], ...]) -> None:
    for option, value in options + _LET_GO_WHEN_HALF_OPEN:
        socket.setsockopt(option, value)
    # Told so for an address of IPv6 alone: others would be looked up as one, too.
    socket.setsockopt(zmq.IPV6, int(address.startswith("tcp://[")))
    if keys:
        socket.curve_serverkey, socket.curve_publickey, socket.curve_secretkey = (key.encode() for key in keys)
    try:
        socket.connect(address)
    except zmq.ZMQError as error:
        raise Failure("bad-address", f"nothing can be connected to {address[:100]}: {error}", address) from None


class Link:
    def __init__(self, context: Any, address: str, keys: Optional[Keys]) -> None:
        self._context, self._keys = context, keys
        self.opened: Callable[[], None] = lambda: None
        self.closing: Callable[[], None] = lambda: None
        self.sent: Callable[[], None] = lambda: None
        self._open(address)

    def _open(self, address: str) -> None:
        self._address = address
        self.socket: Any = self._context.socket(zmq.DEALER)
        self._monitor: Any = self.socket.get_monitor_socket(
            zmq.EVENT_HANDSHAKE_FAILED_AUTH | zmq.EVENT_HANDSHAKE_FAILED_PROTOCOL)
        connect(self.socket, address, self._keys, _AS_A_CLIENT)

    @property
    def file(self) -> int:
        """Which a loop can watch."""
        number: int = self.socket.getsockopt(zmq.FD)
        return number

    def sockets(self) -> List[Any]:
        return [self.socket, self._monitor]

    def begin_again(self, address: Optional[str] = None) -> None:
        """There, or where it was."""
        self.close()
        self._open(address or self._address)
        self.opened()

    def close(self, linger: int = 0) -> None:
        self.closing()
        self.socket.disable_monitor()
        self._monitor.close(linger=0)
        self.socket.close(linger=linger)

    def send(self, text: str) -> bool:
        """False where nobody is connected, or too much waits."""
        try:
            self.socket.send(text.encode(), zmq.DONTWAIT)
        except zmq.Again:
            return False
        self.sent()
        return True

    def wait(self, seconds: float) -> None:
        self.socket.poll(int(seconds * 1000))

    def has_more(self) -> bool:
        return _has_more(self.socket)

    def receive(self) -> Iterator[str]:
        while self.has_more():
            yield self.socket.recv().decode()

    def was_refused(self) -> bool:
        """Whether a handshake failed since this was asked last. ZeroMQ does not try again by itself."""
        refused = False
        while _has_more(self._monitor):
            self._monitor.recv_multipart()
            refused = True
        return refused


def _has_more(socket: Any) -> bool:
    return bool(socket.getsockopt(zmq.EVENTS) & _READABLE)
