"""A stream's newest frames, in memory that its publisher shares with processes of its own user on its machine
(blackboard/streams/stream_door.hpp, shared_ring.hpp).

    guest = RingGuest("pizarra-stream-1f2e", "vision-left")    # the door's name; OSError where nobody is there
    message = guest.poll()                                     # number, microseconds, width, height, channels; pixels
    guest.file                                                 # readable when there may be more

Frames are overwritten while they are read: what is no whole frame of one number is read again, or left for the next.
"""

from __future__ import annotations

import fcntl
import mmap
import os
import select
import socket
import struct
import threading
from typing import List, Optional

WORD = 8
RING = struct.Struct("<3Q")  # mark, words of a slot, frames written
SLOT = struct.Struct("<7Q")  # twice the frame's count, number, microseconds, width, height, channels, bytes
LINE_WORDS, SLOTS, TRIES = 8, 4, 4
MARK = 0x312d656d61726670
GET_SEALS, SEAL_SHRINK = 1034, 2
LONGEST_TEXT, MOST_FILES = 256, 4


class Ring:
    def __init__(self, file: int) -> None:
        """ValueError where the file is no ring, or may shrink under us."""
        if not fcntl.fcntl(file, GET_SEALS) & SEAL_SHRINK:
            raise ValueError("a ring that may shrink")
        self._memory = mmap.mmap(file, os.fstat(file).st_size, prot=mmap.PROT_READ)
        mark, self._slot_words, _ = RING.unpack_from(self._memory)
        if mark != MARK or (LINE_WORDS + SLOTS * self._slot_words) * WORD != len(self._memory):
            raise ValueError("not a ring of frames")
        self._read = 0
        self._fence = threading.Lock()

    def newest(self) -> Optional[bytes]:
        for _ in range(TRIES):
            count = RING.unpack_from(self._memory)[2]
            if count == self._read:
                return None
            message = self._copy(count)
            if message is not None:
                self._read = count
                return message
        return None

    def _copy(self, count: int) -> Optional[bytes]:
        begin = (LINE_WORDS + (count - 1) % SLOTS * self._slot_words) * WORD
        sequence, *header, size = SLOT.unpack_from(self._memory, begin)
        if sequence != 2 * count or size > (self._slot_words - LINE_WORDS) * WORD:
            return None
        pixels = begin + LINE_WORDS * WORD
        message = struct.pack("<5Q", *header) + self._memory[pixels:pixels + size]
        with self._fence:  # also where a processor reads in another order, the pixels were read by now
            after = SLOT.unpack_from(self._memory, begin)[0]
        return message if after == sequence else None

    def close(self) -> None:
        self._memory.close()


class RingGuest:
    def __init__(self, door: str, stream: str) -> None:
        self._ring: Optional[Ring] = None
        self._bell = -1
        self._epoll = select.epoll()
        self._socket = socket.socket(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        try:
            self._socket.connect("\0" + door)
            owner = struct.unpack("3i", self._socket.getsockopt(socket.SOL_SOCKET, socket.SO_PEERCRED, 12))[1]
            if owner not in (0, os.geteuid()):
                raise PermissionError("the process that shows these images belongs to another user")
            self._socket.setblocking(False)
            self._socket.send(stream.encode())
            self._epoll.register(self._socket, select.EPOLLIN)
        except BaseException:
            self.close()
            raise

    @property
    def file(self) -> int:
        return self._epoll.fileno()

    def poll(self) -> Optional[bytes]:
        for number, _ in self._epoll.poll(0):
            if number == self._socket.fileno():
                self._hear()
        return self._ring.newest() if self._ring else None

    def _hear(self) -> None:
        """A ring comes with the first frame, and again when frames have grown, with the same bell."""
        try:
            text, files, _, _ = socket.recv_fds(self._socket, LONGEST_TEXT, MOST_FILES)
        except BlockingIOError:
            return
        try:
            if not text:
                raise ValueError("the publisher is gone")
            self._take(files)
        except ValueError:
            self._epoll.unregister(self._socket)  # nor is a ring taken that is none of ours
        finally:
            for file in files:
                if file != self._bell:
                    os.close(file)

    def _take(self, files: List[int]) -> None:
        if len(files) != 2:
            return
        ring = Ring(files[0])
        if self._ring:
            self._ring.close()
        self._ring = ring
        if self._bell < 0:
            self._bell = files[1]
            # Every ring is told once: the bell is everybody's, and nobody reads it.
            self._epoll.register(self._bell, select.EPOLLIN | select.EPOLLET)

    def close(self) -> None:
        self._socket.close()
        self._epoll.close()
        if self._ring:
            self._ring.close()
        if self._bell >= 0:
            os.close(self._bell)
        self._ring, self._bell = None, -1
