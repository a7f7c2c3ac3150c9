"""Looks of a detector of one's own: look_test.py PIZARRA-BOARD"""

import unittest

import a_board
from a_board import BoardTest
from pizarra import Board, write
from pizarra.look import RELATION, CameraModel, Sighting, found, known, look

MODEL = CameraModel(320, 240, 400.0, 160.0, 120.0, 60.0)
IDENTITY = [1.0, *[0.0] * 5, 1.0, *[0.0] * 4, 1.0, *[0.0] * 3, 1.0, *[0.0] * 2, 1.0, 0.0, 1.0]


class Looks(unittest.TestCase):
    def test_a_pose_becomes_the_places_in_both_images_and_the_range(self):
        seen = MODEL.sighting((10.0, -20.0, 800.0, 1.0, 2.0, 3.0), 0.97, 0.5, IDENTITY)
        self.assertEqual(seen.left, (160 + 400 * 40 / 800, 120 - 400 * 20 / 800))
        self.assertEqual(seen.right, (160 - 400 * 20 / 800, 110))
        self.assertEqual(seen.left[0] - seen.right[0], 400 * 60 / 800)
        self.assertAlmostEqual(seen.range_mm, 800.3124, 3)
        fact = look("detector", 7, ["circle"], {"circle": seen})
        self.assertEqual(write(fact[4][0][-1]), f"(pose 10.0 -20.0 800.0 1.0 2.0 3.0 {write(IDENTITY)})")

    def test_the_range_is_the_straight_way_also_to_what_is_far_aside(self):
        self.assertAlmostEqual(MODEL.sighting((300.0, 0.0, 400.0), 1).range_mm, 500)

    def test_a_place_alone_is_told_without_a_pose(self):
        fact = look("detector", 7, ["circle"], {"circle": MODEL.sighting((0, 0, 600), 1)})
        self.assertEqual([str(part[0]) for part in fact[4][0][3:]], ["left", "right", "range"])

    def test_what_is_behind_the_camera_is_refused(self):
        with self.assertRaises(ValueError):
            MODEL.sighting((0, 0, -1), 1)

    def test_the_texts_are_those_of_the_eyes(self):
        seen = Sighting((112.25, 87.5), 812.3, 0.988, (66.1, 87.5), 0.57)
        told = look("vision", 41, ["circle", "cross"], {"circle": seen})
        self.assertEqual(told[3], '(TRACK 2 ("circle" OK (112.25, 87.50, 812.30)) ("cross" FAIL))')
        self.assertEqual(write(told[4]), '(("circle" seen 0.988 (left 112.25 87.5) (right 66.1 87.5) (range 812.3 0.57))'
                                         ' ("cross" lost))')
        self.assertEqual(found("circle", seen), '(FIND "circle" OK (112.25, 87.50))')
        self.assertEqual(found("cross", None), '(FIND "cross" FAIL)')
        self.assertEqual(known(["circle", "cross"]), '(GET 2 ("circle", "cross"))')


class OnABoard(BoardTest):
    def test_a_board_takes_a_look(self):
        with Board(self.address, "detector") as board:
            board.declare(RELATION)
            board.tell(look("detector", 1, ["circle"], {"circle": MODEL.sighting((0, 0, 600), 0.9)}))
            self.assertEqual(len(board.ask("(look detector 1 ?text ?of)")), 1)


a_board.run(__name__)
