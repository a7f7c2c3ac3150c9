"""Jobs for a cell: each (job NUMBER GOAL) that anybody tells is pursued once, one after the other.

    ./pizarra up examples/01-blocks/cell.scm                                  prints the board's address
    PYTHONPATH=blackboard/python python3 examples/17-jobs/jobs.py BOARD-ADDRESS
    ./pizarra tell '(job 1 (on circle triangle))'
    ./pizarra watch '(job-ended ?number ?state)'

Jobs wait on the board while this is away. Several of these programs share the work: no job is taken twice, and one
that was taken by a program that died comes back.
"""

import argparse

from pizarra import Board, Contract, Failure, Presence, Symbol, settle, tell

CONTRACT = Contract("jobs", takes=["job"], reads=["event", "goal-state"], monitors=["job-ended"],
                    posts=["(relation job ((number integer) (goal list)) (key number) (durable))",
                           "(relation job-ended ((number integer) (state symbol)) (key number) (durable))"])
LONGEST_S = 600  # that a goal is waited for


def pursue(board, goal):
    """How it ended: reached, refused, replaced or cancelled."""
    [number] = board.request(board.server("coordinator"), [Symbol("goal"), goal])
    try:
        ended = board.await_answer(f"(and (goal-state {number} ?state ?) (/= ?state running))", LONGEST_S)
    except Failure:
        board.send(board.server("coordinator"), "(cancel)")
        raise
    return ended.bindings["?state"]


def main():
    parser = argparse.ArgumentParser(description="Pursues the jobs that are told to a cell.")
    parser.add_argument("board", metavar="BOARD-ADDRESS", help="as `pizarra ps` shows it")
    parser.add_argument("--name", default="jobs", help="how it is called; each of several has a name of its own")
    choices = parser.parse_args()
    with Board(choices.board, choices.name) as board:
        presence = Presence(choices.name, CONTRACT)
        board.run(presence.come())
        while True:
            job = board.event("(job ?number ?goal)", timeout=float("inf"), lease=presence.lease)
            _, number, goal = job.datum
            try:
                state = pursue(board, goal)
            except Failure as failure:
                state = Symbol(failure.symbol)
            board.transact([settle(job.id), tell([Symbol("job-ended"), number, state])])
            newest = board.pull("(event ?number ?kind ?sentence ?detail)")
            print(f"job {number} is {state}: {newest.datum[3] if newest else 'nothing was told'}", flush=True)


if __name__ == "__main__":
    try:
        main()
    except KeyboardInterrupt:
        pass
