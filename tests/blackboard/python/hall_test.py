"""The example that gives a hall's jobs to its cells, before cells whose coordinators are played here.

hall_test.py PIZARRA-BOARD
"""

import os
import signal
import subprocess
import sys

import a_board
from a_board import PATIENCE, BoardTest, free_address
from pizarra import Board

DISPATCHER = os.path.join(os.path.dirname(__file__), "../../../examples/14-hall/dispatcher.py")
# Ends each goal with the state that it is started with, half a second after it was given.
COORDINATOR = """
import asyncio, sys
from pizarra import Agent, Symbol
agent = Agent("coordinator", posts=["(relation goal ((n integer) (forms list)) (key n) (durable))",
                                    "(relation goal-state ((n integer) (state symbol) (detail datum)) (key n) (durable))"])
numbers = iter(range(1, 100))
@agent.operation("(goal (form datum))")
async def goal(form):
    n = next(numbers)
    await agent.board.tell([Symbol("goal"), n, [form]])
    await agent.board.tell([Symbol("goal-state"), n, Symbol("running"), []])
    async def end():
        await asyncio.sleep(0.5)
        await agent.board.tell([Symbol("goal-state"), n, Symbol(sys.argv[2]), []])
    asyncio.ensure_future(end())
    return n
asyncio.run(agent.serve(sys.argv[1]))
"""
JOB = "(relation job ((n integer) (goal list)) (key n) (durable))"
NAMED = "(relation context-board ((name symbol) (address string)) (key name) (durable))"


class AHall(BoardTest):
    def setUp(self):
        super().setUp()
        self.hall = self.client()
        self.hall.declare(JOB, NAMED)
        self.cells = {}

    def start(self, *words):
        process = subprocess.Popen([sys.executable, *words])
        self.addCleanup(a_board.end, process, signal.SIGTERM)
        return process

    def add_cell(self, name, ends_with):
        address = free_address()
        server = self.start_board(address)
        if ends_with is not None:
            self.start("-c", COORDINATOR, address, ends_with)
        self.hall.tell(f'(context-board {name} "{address}")')
        self.cells[name] = Board(address, "looker", timeout=PATIENCE)
        self.addCleanup(self.cells[name].close)
        return server

    def states(self):
        if not self.hall.ask("(relation-stats job-state ? ? ? ? ? ?)"):
            return {}
        return {a.bindings["?n"]: (str(a.bindings["?state"]), str(a.bindings["?cell"]))
                for a in self.hall.ask("(job-state ?n ?state ?cell ?)")}

    def goals_of(self, name):
        return len(self.cells[name].ask("(goal ?n ?forms)"))

    def ended(self, *numbers):
        states = self.states()
        return all(states.get(n, ("", ""))[0] in ("reached", "failed") for n in numbers)

    def test_cells_share_the_jobs_and_what_one_cannot_do_another_does(self):
        self.add_cell("bad", "refused")
        self.add_cell("good", "reached")
        for n in (1, 2, 3):
            self.hall.tell(f"(job {n} ((on circle triangle)))")
        self.start(DISPATCHER, self.address)
        self.until(lambda: self.ended(1, 2, 3))
        self.assertEqual(self.states(), {n: ("reached", "good") for n in (1, 2, 3)})
        self.assertGreaterEqual(self.goals_of("bad"), 1)

    def test_a_job_that_every_cell_refuses_is_failed(self):
        self.add_cell("bad", "refused")
        self.hall.tell("(job 7 ((on circle triangle)))")
        self.start(DISPATCHER, self.address)
        self.until(lambda: self.ended(7))
        self.assertEqual(self.states(), {7: ("failed", "none")})

    def test_a_job_waits_for_a_cell_whose_coordinator_is_not_there_yet(self):
        self.add_cell("bad", "refused")
        self.add_cell("late", None)
        self.hall.tell("(job 4 ((on circle triangle)))")
        self.start(DISPATCHER, self.address)
        self.until(lambda: self.states().get(4) == ("given", "bad"))
        self.start("-c", COORDINATOR, self.cells["late"].address, "reached")
        self.until(lambda: self.ended(4))
        self.assertEqual(self.states(), {4: ("reached", "late")})

    def test_a_dispatcher_that_is_killed_and_started_again_gives_no_goal_twice(self):
        self.add_cell("slow", "reached")
        self.hall.tell("(job 1 ((on circle triangle)))")
        first = self.start(DISPATCHER, self.address)
        self.until(self.states)
        a_board.end(first, signal.SIGKILL)
        self.start(DISPATCHER, self.address)
        self.until(lambda: self.ended(1))
        self.assertEqual(self.states(), {1: ("reached", "slow")})
        self.assertEqual(self.goals_of("slow"), 1)


a_board.run(__name__)
