"""An agent's presence: (agent NAME KIND HOST) and its contract, told under a lease that ends two seconds after it died.

    presence = Presence("lamp", Contract("lamp", posts=["(relation lamp ((colour symbol)) (key))"]))
    board.run(presence.come())                              # declares; waits until the name is free
    while True:
        board.wait(0.1)                                     # every call of the board renews the lease
        if board.run(presence.keep()):                      # the board was started again, or had forgotten us
            ...                                             # tell again what stands under presence.lease
    board.run(presence.leave())

Who offers anything is bound by its name, too, so that others find it by its kind (docs/facts/agents.md, Names). On an
AsyncBoard, await the same flows; Agent (agent.py) does.
"""

from __future__ import annotations

import socket
import time
from typing import Any, Callable, List, Optional

from pizarra import board_calls
from pizarra.contract import Contract
from pizarra.datum import Symbol
from pizarra.failure import AWAY, Failure
from pizarra.flow import Flow, Keep, Pause, do
from pizarra.steps import absent, tell
from pizarra.writer import check_teller

NAMING_RELATIONS = [
    "(relation context ((parent list) (name symbol)) (key parent name) (durable))",
    "(relation bound ((parent list) (name symbol) (kind symbol) (agent symbol)) (key parent name))",
]
# Where a kind of Pizarra's own is bound; any other one has a context that is called like itself.
CONTEXTS = {"robot": "arms", "vision": "eyes", "pan-tilt": "heads", "planner": "planners",
            "coordinator": "coordinators", "person": "people"}


class Presence:
    LEASE, RENEWAL, RETRY = 2.0, 0.5, 0.2

    def __init__(self, name: str, contract: Contract, host: Optional[str] = None, context: Optional[str] = None) -> None:
        check_teller(name)
        self.name, self.contract = name, contract
        self.host = host or socket.gethostname()
        self.context = context or CONTEXTS.get(contract.kind, contract.kind)
        self.lease = 0  # what should go with the agent is told under it
        self.is_taken = False  # its name, by another one, when that was tried last
        self.on_lease: Callable[[], None] = lambda: None
        self._told = 0.0
        self._may_bind = bool(contract.offers)

    def come(self) -> Flow[None]:
        yield from _until_reached(board_calls.declare(self.contract.relations), self.RETRY)
        while not (yield from self._announce()):
            yield Pause(self.RETRY)

    def keep(self) -> Flow[bool]:
        """To be run often: tells who is here again when that is due. True where presence began anew, under another lease."""
        if time.monotonic() < self._told + self.RENEWAL:
            return False
        try:
            # It changes nothing unless somebody retracted it: who lives is present.
            yield from do(board_calls.transact(self._facts(self.lease)))
            yield from self._bind()
        except Failure as failure:
            if failure.symbol == "unknown-lease":
                return (yield from self._announce())
            if failure.symbol not in AWAY:
                raise
        self._told = time.monotonic()
        return False

    def leave(self) -> Flow[None]:
        """The name is free at once."""
        yield Keep(self.lease, 0)
        try:
            yield from do(board_calls.release(self.lease))
        except Failure as failure:
            if failure.symbol not in ("unknown-lease", *AWAY):
                raise

    def _announce(self) -> Flow[bool]:
        """One try to stand on the board under the agent's name; false where another one has it, or none answers."""
        lease = 0
        try:
            lease = yield from do(board_calls.lease(self.LEASE))
            vacant = absent([Symbol("agent"), Symbol(self.name), Symbol("?"), Symbol("?")])
            yield from do(board_calls.transact(self._facts(lease), [vacant]))
        except Failure as failure:
            self.is_taken = failure.symbol == "precondition-failed"
            if self.is_taken:
                yield from do(board_calls.release(lease))
            elif failure.symbol not in (*AWAY, "unknown-lease"):
                raise
            return False
        yield Keep(lease, self.RENEWAL)
        self.lease, self._told = lease, time.monotonic()
        self.on_lease()
        yield from self._bind()
        return True

    def _facts(self, lease: int) -> List[Any]:
        name = Symbol(self.name)
        return [tell([Symbol("agent"), name, Symbol(self.contract.kind), self.host], lease),
                tell([Symbol("contract"), name, self.contract.form], lease)]

    def _bind(self) -> Flow[None]:
        """A key that was made for less need not let it; then who knows its name finds it, and nobody else."""
        if not self._may_bind:
            return
        cell, name, kind = Symbol("cell"), Symbol(self.name), Symbol(self.contract.kind)
        context = Symbol(self.context)
        binding = board_calls.transact([tell([Symbol("context"), [], cell]), tell([Symbol("context"), [cell], context]),
                                  tell([Symbol("bound"), [cell, context], name, kind, name], self.lease)])
        try:
            try:
                yield from do(binding)
            except Failure as failure:
                if failure.symbol != "undeclared-relation":
                    raise
                yield from do(board_calls.declare(NAMING_RELATIONS))
                yield from do(binding)
        except Failure as failure:
            self._may_bind = failure.symbol != "not-permitted"
            _pass_with_time(failure, "not-permitted")


def _pass_with_time(failure: Failure, *others: str) -> None:
    if failure.symbol not in (*AWAY, "unknown-lease", *others):
        raise failure


def _until_reached(call: board_calls.Call[None], pause: float) -> Flow[None]:
    while True:
        try:
            return (yield from do(call))
        except Failure as failure:
            _pass_with_time(failure)
        yield Pause(pause)
