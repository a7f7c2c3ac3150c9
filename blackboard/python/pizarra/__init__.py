"""Pizarra from Python: a client of a board, and a kit for agents. docs/python.md is its page.

    from pizarra import Board, AsyncBoard, Agent, Symbol

One module is one idea:
    datum, reader, writer           data, and the text that they are
    relation, answers, steps        what is declared, asked and told
    board, aio                      the board, for one thing after another and for asyncio
    watch, aio_watch                changes and images, as they come
    presence, contract, agent       an agent: who is there, what it offers, and the loop around it
    agent_patterns                  how agents meet: QUERY, SEND, pull, EVENT, WIRING
    replica, stream                 facts that are held here; images
    look                            what a detector of one's own tells
    session, session_requests, board_calls, watch_feed, leases, link, addresses, keys, flow, service, aio_wait
                                    what these stand on

It needs Debian's python3-zmq; images as arrays need python3-numpy.
"""

import sys

try:
    import zmq as _zmq  # noqa: F401
except ImportError as missing:
    raise ImportError("pizarra needs zmq. Debian's python3-zmq is for /usr/bin/python3; for this Python it is pyzmq: "
                      f"{sys.executable} -m pip install pyzmq") from missing

from pizarra.agent import Agent
from pizarra.agent_patterns import Holder
from pizarra.aio import AsyncBoard
from pizarra.aio_watch import AsyncStream, AsyncWatch
from pizarra.answers import Answer, Answers, Change, Fact, Recalled
from pizarra.board import Board
from pizarra.contract import Contract
from pizarra.datum import Datum, Symbol
from pizarra.failure import Failure
from pizarra.presence import Presence
from pizarra.reader import read, read_all
from pizarra.session_requests import Request
from pizarra.steps import absent, present, retract, settle, tell, unchanged
from pizarra.stream import Frame
from pizarra.watch import Stream, Watch
from pizarra.writer import write

__version__ = "0.1.0"

__all__ = ["Agent", "Answer", "Answers", "AsyncBoard", "AsyncStream", "AsyncWatch", "Board", "Change", "Contract",
           "Datum", "Fact", "Failure", "Frame", "Holder", "Presence", "Recalled", "Request", "Stream", "Symbol", "Watch",
           "absent", "present", "read", "read_all", "retract", "settle", "tell", "unchanged", "write"]
