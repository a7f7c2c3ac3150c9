"""Leases that are renewed by themselves, whenever the board is spoken with.

    leases.keep(lease, every=0.5)
    leases.renew_due(now)
"""

from __future__ import annotations

import time
from typing import Callable, Dict, NamedTuple, Optional

from pizarra.failure import Failure
from pizarra.session_requests import Request


class _Kept(NamedTuple):
    every: float
    due: float
    renewal: Optional[Request]


class Leases:
    def __init__(self, renew: Callable[[int], Request]) -> None:
        self._renew = renew
        self._kept: Dict[int, _Kept] = {}

    def keep(self, lease: int, every: float) -> None:
        """Until the board knows it no more; `every` 0: no longer."""
        self._kept.pop(lease, None)
        if every > 0:
            self._kept[lease] = _Kept(every, time.monotonic() + every, None)

    def renew_due(self, now: float) -> None:
        for lease, (every, due, renewal) in list(self._kept.items()):
            if renewal and isinstance(renewal.result, Failure) and renewal.result.symbol == "unknown-lease":
                del self._kept[lease]
            elif due <= now and (renewal is None or renewal.result is not None):
                self._kept[lease] = _Kept(every, now + every, self._renew(lease))
