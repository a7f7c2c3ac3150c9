"""The example that pursues jobs, beside a cell that runs: jobs_test.py PIZARRA-CELL SOURCE-DIR

Ends with 77, and says why, where Python has no zmq.
"""

import importlib.util
import os
import sys
import unittest

if importlib.util.find_spec("zmq") is None:
    print("skipped: python3-zmq is not installed")
    sys.exit(77)

from running_cell import CellTest, source

sys.path.insert(0, os.path.join(source, "blackboard/python"))
from pizarra import Board

PATIENCE_S = 240


class Jobs(CellTest):
    def test_are_pursued_once_each_also_those_of_a_program_that_died(self):
        address = self.start_cell()
        with Board(address, "test") as board:
            board.declare("(relation job ((number integer) (goal list)) (key number) (durable))",
                          "(relation job-ended ((number integer) (state symbol)) (key number) (durable))")
            first = self.start(self.example("17-jobs/jobs.py", address))
            board.tell("(job 1 (holding circle))")
            board.await_answer("(goal-state ?n running ?)", PATIENCE_S)
            self.assertEqual(len(board.ask("(job ?n ?goal)")), 0, "it has been taken")
            first.kill()
            board.await_answer("(job 1 ?goal)", PATIENCE_S)
            self.start(self.example("17-jobs/jobs.py", address))
            board.tell("(job 2 (levitating circle))")
            board.await_answer("(job-ended 2 ?state)", PATIENCE_S)
            states = {answer.bindings["?n"]: answer.bindings["?s"] for answer in board.ask("(job-ended ?n ?s)")}
            self.assertEqual(sorted(states), [1, 2])
            self.assertNotEqual(states[2], "reached", "nothing of that kind can be wanted")


unittest.main()
