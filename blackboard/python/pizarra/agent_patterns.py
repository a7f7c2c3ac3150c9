"""How agents meet through facts, each way written once for both boards (flow.py). docs/facts/agents.md names the patterns.

    values = board.request("coordinator", "(goal (on-table lid))")        # QUERY
    board.send("pan-tilt", "(pan 30)")                                    # SEND
    newest = board.pull("(look ?eyes ?frame ?text ?objects)")             # what was PUSHed last; watch for all of it
    fact = board.event("(job ?n)", timeout=60)                            # EVENT: this client alone has it
    eyes = board.holder("coordinator", "eyes").server                     # WIRING: who serves another client
    [number] = board.request(board.server("coordinator"), goal)           # WIRING: who serves this one
"""

from __future__ import annotations

import time
import uuid
from typing import Any, List, NamedTuple, Optional

from pizarra import board_calls
from pizarra.answers import Fact, query_of, relations_of
from pizarra.board_calls import Call
from pizarra.contract import RUNTIME_RELATIONS
from pizarra.datum import Symbol
from pizarra.failure import AWAY, Failure, failure_from
from pizarra.flow import Flow, Pause, do, until
from pizarra.steps import retract, tell
from pizarra.writer import datum_of

LOOK = 1.0      # how often who waits asks whether the board still knows of it
RETRY = 0.2


# The kind of those that can play a role, the context in which they are bound, and who does where nobody is wired.
ROLES = {"robot": ("robot", "arms", "robot"), "eyes": ("vision", "eyes", "vision"),
         "planner": ("planner", "planners", "planner"), "coordinator": ("coordinator", "coordinators", "coordinator")}


class Holder(NamedTuple):
    server: str
    state: str  # wired, stands-in, absent


def retraction(pattern: Any) -> Call[int]:
    return board_calls.transact([retract(pattern)])


def request(teller: str, agent: str, operation: Any, timeout: float) -> Flow[List[Any]]:
    """What the agent answers, without the `ok`. Failures: the agent's, and `timeout`; the request is then withdrawn.

    A request that the board forgot, as one that was started again does, is told again under its ID: an agent does it
    once. It goes when its caller dies."""
    number = Symbol(f"{teller}-{uuid.uuid4().hex}")
    fact = [Symbol("request"), number, Symbol(agent), datum_of(operation)]
    deadline = time.monotonic() + timeout
    lease: int = 0
    reply: Optional[Any] = None
    while reply is None and time.monotonic() < deadline:
        try:
            lease = lease or (yield from _tell(fact))
            reply = yield from _reply_to(number, min(LOOK, deadline - time.monotonic()))
            if reply is None:
                yield from do(board_calls.renew(lease))
        except Failure as failure:
            if failure.symbol not in (*AWAY, "unknown-lease"):
                raise
            lease = lease if failure.symbol in AWAY else 0
            yield Pause(RETRY)
    yield from _withdraw(number, lease)
    if reply is None:
        raise (yield from _late(agent, fact[3], timeout))
    return _values(reply, agent)


def _tell(fact: List[Any]) -> Flow[int]:
    lease = yield from do(board_calls.lease(4 * LOOK))
    told = board_calls.transact([tell(fact, lease)])
    try:
        yield from do(told)
    except Failure as failure:
        if failure.symbol != "undeclared-relation":
            raise
        yield from do(board_calls.declare(RUNTIME_RELATIONS))
        yield from do(told)
    return lease


def _reply_to(number: Symbol, seconds: float) -> Flow[Optional[Any]]:
    try:
        answer = yield from until([Symbol("reply"), number, Symbol("?result")], max(0.0, seconds))
    except Failure as failure:
        if failure.symbol != "timeout":
            raise
        return None
    return answer.facts[0].datum[2]


def _withdraw(number: Symbol, lease: int) -> Flow[None]:
    every = Symbol("?")
    try:
        yield from do(board_calls.transact([retract([Symbol("request"), number, every, every]),
                                      retract([Symbol("reply"), number, every])]))
        if lease:
            yield from do(board_calls.release(lease))
    except Failure as failure:
        # A lease that the board has forgotten, or that is away with it, goes by itself.
        if failure.symbol not in (*AWAY, "unknown-lease", "undeclared-relation"):
            raise


def _late(agent: str, operation: Any, timeout: float) -> Flow[Failure]:
    """What to fail with when nothing was answered."""
    sentence = f"{agent} did not answer in {timeout:.1f} s"
    try:
        if not (yield from do(board_calls.ask([Symbol("agent"), Symbol(agent), Symbol("?"), Symbol("?")]))):
            sentence += ": no agent of that name is there"
    except Failure as failure:
        if failure.symbol == "unreachable":
            sentence += ", and the board does not either"
    return Failure("timeout", sentence, operation)


def _values(reply: Any, agent: str) -> List[Any]:
    if reply[:1] == [Symbol("fail")] and len(reply) in (4, 5):
        raise failure_from(reply)
    if reply[:1] != [Symbol("ok")]:
        raise Failure("bad-reply", f"{agent} answered neither ok nor fail", reply)
    return list(reply[1:])


def send(teller: str, agent: str, operation: Any, lease: int) -> Flow[None]:
    """The agent does it when it comes to it, its successor if it dies. What has not been taken goes with the lease."""
    number = Symbol(f"{teller}-{uuid.uuid4().hex}")
    told = board_calls.transact([tell([Symbol("request"), number, Symbol(agent), datum_of(operation)], lease)])
    try:
        yield from do(told)
    except Failure as failure:
        if failure.symbol != "undeclared-relation":
            raise
        yield from do(board_calls.declare(RUNTIME_RELATIONS))
        yield from do(told)


def pull(pattern: Any) -> Flow[Optional[Fact]]:
    answers = yield from do(board_calls.ask(pattern))
    facts = [answer.facts[0] for answer in answers]
    return max(facts, key=lambda fact: (fact.revision, fact.id)) if facts else None


def event(pattern: Any, timeout: float, lease: int) -> Flow[Fact]:
    deadline = time.monotonic() + timeout
    while True:
        fact = yield from do(board_calls.take(pattern, lease))
        if fact is not None:
            return fact
        # Another client may take it first.
        yield from until(pattern, max(0.0, deadline - time.monotonic()))


def holder(client: str, role: str) -> Flow[Holder]:
    answers = yield from do(board_calls.ask([Symbol("holder"), Symbol(client), Symbol(role), Symbol("?server"),
                                       Symbol("?state")]))
    if not answers:
        raise Failure("absent", f"{client} has nobody for {role}, or is not there", Symbol(role))
    return Holder(str(answers[0].bindings["?server"]), str(answers[0].bindings["?state"]))


def server(client: str, role: str) -> Flow[str]:
    """Who plays the role for a client that asks once, chosen as for every other (docs/facts/agents.md, Roles): who is
    wired to it; where that one is away, the next in line by name."""
    if role not in ROLES:
        raise Failure("unknown-role", f"there is no role {role}: it is one of {', '.join(ROLES)}", Symbol(role))
    kind, context, usual = ROLES[role]
    name, any_one = Symbol("?name"), Symbol("?")
    wired = yield from _names([Symbol("wired"), Symbol(client.rpartition("/")[2]), Symbol(role), name])
    present = yield from _names([Symbol("agent"), name, Symbol(kind), any_one])
    bound = yield from _names([Symbol("bound"), [Symbol("cell"), Symbol(context)], any_one, any_one, name])
    first = wired[0] if wired else usual
    if first in present:
        return first
    line = sorted(agent for agent in bound if agent in present)
    if not line:
        raise Failure("absent", f"nobody is present who could be the {role}", Symbol(role))
    return next((agent for agent in line if agent > first), line[0])


def _names(pattern: Any) -> Flow[List[str]]:
    """What ?name is in the facts that fit; none where nobody has declared them."""
    try:
        answers = yield from do(board_calls.ask(pattern))
    except Failure as failure:
        if failure.symbol != "undeclared-relation":
            raise
        return []
    return [str(answer.bindings["?name"]) for answer in answers]


def are_declared(query: Any) -> Flow[bool]:
    """Whether somebody has declared what the query is about. Who may not ask about relations takes them for declared."""
    every = [Symbol("?")] * 6
    try:
        for relation in relations_of(query_of(query)):
            if not (yield from do(board_calls.ask([Symbol("relation-stats"), Symbol(relation), *every]))):
                return False
    except Failure as failure:
        if failure.symbol in AWAY:
            return False
        if failure.symbol != "not-permitted":
            raise
    return True
