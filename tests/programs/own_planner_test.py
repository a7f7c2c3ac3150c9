"""The example's planner in the planner's role of a cell that runs: own_planner_test.py PIZARRA-CELL SOURCE-DIR

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
from pizarra import Board, Failure

PATIENCE_S = 180
BLOCKS = """((operator PICK-UP (params (<a> OBJECT)) (preconds (clear <a>) (arm-empty))
               (effects (holding <a>) (del (clear <a>)) (del (arm-empty))))
             (operator STACK (params (<a> OBJECT) (<b> OBJECT)) (preconds (holding <a>) (clear <b>))
               (effects (on <a> <b>) (clear <a>) (arm-empty) (del (holding <a>)) (del (clear <b>)))))"""
TYPES = "(types (circle OBJECT) (square OBJECT) (cross OBJECT))"
INITIALS = "(initials (clear circle) (clear square) (clear cross) (arm-empty))"


class APlannerOfOnesOwn(CellTest):
    def test_takes_the_planners_role_and_the_cell_does_what_it_planned(self):
        address = self.start_cell()
        with Board(address, "test") as board:
            planner = self.start(self.example("16-own-planner/planner.py", address))
            board.await_answer("(agent breadth-first planner ?host)", PATIENCE_S)
            self.plans_a_tower(board)
            self.hands_out_what_serves(board)
            self.refuses_what_cannot_be(board)
            board.tell("(wired coordinator planner breadth-first)")
            board.await_answer("(holder coordinator planner breadth-first wired)", PATIENCE_S)
            [number] = board.request("coordinator", "(goal (on circle square))", timeout=PATIENCE_S)
            board.await_answer(f"(goal-state {number} reached ?)", PATIENCE_S)
            # The cell's own planner stands in for it when it dies.
            planner.kill()
            board.await_answer("(holder coordinator planner planner stands-in)", PATIENCE_S)

    def ask(self, board, operation):
        return words(board.request("breadth-first", operation, timeout=PATIENCE_S))

    def plans_a_tower(self, board):
        goals = "(goals (on circle square) (on cross circle))"
        [plan] = self.ask(board, f"(make-plan 7 {BLOCKS} {TYPES} {INITIALS} {goals})")
        self.assertEqual(plan, [[["PICK-UP", "circle"]], [["STACK", "circle", "square"]], [["PICK-UP", "cross"]],
                                [["STACK", "cross", "circle"]]])

    def hands_out_what_serves(self, board):
        """Somebody else has put the circle on the square: the first two operations are skipped."""
        index, rest, needed, after = self.ask(
            board, "(next-operation 7 ((on circle square) (clear circle) (clear cross) (arm-empty)))")
        self.assertEqual((index, rest[0]), ("2", ["PICK-UP", "cross"]))
        self.assertIn(["clear", "cross"], needed)
        self.assertIn(["holding", "cross"], after)
        with self.assertRaises(Failure) as refused:
            self.ask(board, "(next-operation 7 ((arm-empty)))")
        self.assertEqual(refused.exception.symbol, "off-plan")

    def refuses_what_cannot_be(self, board):
        for goals, symbol in (("(on circle square) (on square circle)", "no-plan"), ("(or (arm-empty))", "bad-task")):
            with self.assertRaises(Failure) as refused:
                self.ask(board, f"(try-plan {BLOCKS} {TYPES} {INITIALS} (goals {goals}))")
            self.assertEqual(refused.exception.symbol, symbol)


def words(value):
    """Symbols as text, in lists of lists."""
    return [words(part) for part in value] if isinstance(value, (list, tuple)) else str(value)


unittest.main()
