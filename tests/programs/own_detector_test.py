"""The example's detector in the eyes' role of a cell that runs: own_detector_test.py PIZARRA-CELL SOURCE-DIR

Ends with 77, and says why, where Python has no zmq.
"""

import asyncio
import importlib.util
import os
import sys
import time
import unittest

if importlib.util.find_spec("zmq") is None:
    print("skipped: python3-zmq is not installed")
    sys.exit(77)

from running_cell import CellTest, source

sys.path.insert(0, os.path.join(source, "blackboard/python"))
from pizarra import AsyncBoard, Board

PATIENCE_S = 180


class ADetectorOfOnesOwn(CellTest):
    def test_takes_the_eyes_role_and_the_arm_goes_by_what_it_sees(self):
        address = self.start_cell()
        with Board(address, "test") as board:
            self.images_come(board)
            asyncio.run(self.images_come_in_asyncio(address))
            detector = self.start(self.example("13-own-eyes/detector.py", address))
            board.await_answer("(agent detector vision ?host)", PATIENCE_S)
            board.tell("(wired coordinator eyes detector)")
            board.await_answer("(holder coordinator eyes detector wired)", PATIENCE_S)
            board.request("coordinator", "(goal (holding circle))", timeout=PATIENCE_S)
            self.places_come_of_its_looks(board)
            # The arm is led to what is held to be seen there. Whether it grasps in time is the machine's load.
            board.await_answer("(servo ?state circle ?x ?y ?d)", PATIENCE_S)
            # The cell's own eyes stand in for it when it dies.
            detector.kill()
            board.await_answer("(holder coordinator eyes vision stands-in)", PATIENCE_S)

    def images_come(self, board):
        with board.stream("vision-left") as stream:
            first, second = stream.next(PATIENCE_S), stream.next(PATIENCE_S)
        self.assertEqual((first.width, first.height, first.channels, len(first.pixels)), (320, 240, 1, 320 * 240))
        self.assertGreater(second.number, first.number)
        self.assertGreater(len(set(first.pixels)), 20, "an image has many greys")

    async def images_come_in_asyncio(self, address):
        async with AsyncBoard(address, "test-2") as board, board.stream("vision-colour") as stream:
            first, second = await stream.next(PATIENCE_S), await stream.next(PATIENCE_S)
        self.assertEqual((first.channels, len(first.pixels)), (3, 3 * 320 * 240))
        self.assertGreater(second.number, first.number)

    def places_come_of_its_looks(self, board):
        """A place is told because of the look that showed it."""
        looks, reasons = set(), set()
        deadline = time.monotonic() + PATIENCE_S
        with board.watch("(look detector ? ? ?)") as seen, board.watch("(place circle ? ? ? ?)") as places:
            while not looks & reasons:
                self.assertLess(time.monotonic(), deadline, "no place is told because of the detector's looks")
                looks.update(fact.id for fact in newest(seen))
                reasons.update(reason for fact in newest(places) for reason in fact.because)
                board.wait(0.01)


def newest(watch):
    change = watch.poll()
    return [answer.facts[0] for answer in change.added] if change else []


unittest.main()
