"""Which address of the board is tried, and how long before the next one is, where boards take over from each other.

    addresses = Addresses("tcp://10.0.0.1:7943,tcp://10.0.0.2:7943", now)
    if addresses.is_time_for_the_next(now): addresses.go_on(now)

The one that leads answers; the others stand by in silence.
"""

from __future__ import annotations


class Addresses:
    TRIES_FIRST_FOR, TRIES_LONGEST_FOR = 0.15, 2.0

    def __init__(self, text: str, now: float) -> None:
        # With commas between them. A path may have one.
        self._all = [text] if text.startswith("ipc://") else text.split(",")
        self._at = 0
        self._tried, self._tries_for = now, self.TRIES_FIRST_FOR

    @property
    def current(self) -> str:
        return self._all[self._at]

    @property
    def has_others(self) -> bool:
        return len(self._all) > 1

    def found(self) -> None:
        self._tries_for = self.TRIES_FIRST_FOR

    def lost(self, now: float) -> None:
        """What answered here is gone: it has its time again before the next one is tried."""
        self._tried = now

    def is_time_for_the_next(self, now: float) -> bool:
        return self.has_others and self._tried + self._tries_for <= now

    def go_on(self, now: float) -> None:
        """One that does not welcome within its time stands by, or is gone; over a slow line it may take longer."""
        self._at = (self._at + 1) % len(self._all)
        if self._at == 0:
            self._tries_for = min(self._tries_for * 1.25, self.TRIES_LONGEST_FOR)
        self._tried = now
