"""counter: counts how often a barrier was blocked, tells the count, and may be asked for it.

    python3 counter.py ipc:///tmp/b        on the board that listens there, until Ctrl-C
"""

import sys

from pizarra import Board, Failure, Symbol, settle, tell

RELATIONS = [
    "(relation agent ((name symbol) (kind symbol) (host string)) (key name))",
    "(relation contract ((name symbol) (form datum)) (key name))",
    "(relation request ((id symbol) (agent symbol) (operation datum)) (key id))",
    "(relation reply ((id symbol) (result datum)) (key id) (lease 60000))",
    "(relation barrier ((name symbol) (state symbol)) (key name))",
    "(relation passed ((count integer)) (key))",
]
CONTRACT = """(contract counter
  (offers (count))
  (posts (relation passed ((count integer)) (key)))
  (reads barrier))"""


def come(board):
    """Presence: what is told under this lease goes 2 s after the agent has died."""
    presence = board.lease(2.0)
    board.tell('(agent counter counter "localhost")', presence)
    board.tell(f"(contract counter {CONTRACT})", presence)
    return presence


def serve(board):
    board.declare(*RELATIONS)
    presence, count = come(board), 0
    blocked = board.watch("(barrier ?name blocked)")
    requests = board.watch("(request ?id counter ?operation)")
    while True:
        board.wait(0.05)
        try:
            board.renew(presence)
        except Failure as failure:
            if failure.symbol != "unknown-lease":
                raise
            presence = come(board)  # the board was started again
        while change := blocked.poll():
            for answer in change.added:
                count += 1
                board.tell([Symbol("passed"), count], presence, because=[answer.facts[0].id])
        while change := requests.poll():
            for answer in change.added:
                request = board.take(answer.facts[0].datum, presence)
                if request:
                    reply = [Symbol("reply"), request.datum[1], answer_to(request.datum[3], count)]
                    board.transact([tell(reply), settle(request.id)])


def answer_to(operation, count):
    if operation == [Symbol("count")]:
        return [Symbol("ok"), count]
    return [Symbol("fail"), Symbol("unknown-operation"), "counter offers (count)", operation]


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(f"usage: {sys.argv[0]} BOARD-ADDRESS")
    try:
        with Board(sys.argv[1], "counter") as board:
            serve(board)
    except KeyboardInterrupt:
        pass
