#!/usr/bin/python3
"""The printed shapes are where their truth says, to a thousandth of a millimetre; 77 where the peers are missing."""

import sys
import unittest

try:
    import numpy as np

    import sheets
except ImportError as missing:
    print("skipped:", missing)
    sys.exit(77)


class Shapes(unittest.TestCase):
    def test_have_their_middle_where_the_truth_has_it(self):
        for name in ("circle", "square", "cross", "triangle", "ellipse", "rounded-square"):
            px_a_mm, texture = sheets.shape_texture(name)[0]
            ink = (sheets.PAPER - texture) / (sheets.PAPER - sheets.INK)
            at_mm = (np.arange(len(ink)) + 0.5) / px_a_mm - sheets.SHEET_MM / 2
            with self.subTest(name):
                self.assertAlmostEqual((ink.sum(axis=0) * at_mm).sum() / ink.sum(), 0, delta=0.001)
                self.assertAlmostEqual((ink.sum(axis=1) * at_mm).sum() / ink.sum(), 0, delta=0.001)

    def test_are_as_large_as_they_are_said_to_be(self):
        px_a_mm, texture = sheets.shape_texture("square")[0]
        ink = (sheets.PAPER - texture) / (sheets.PAPER - sheets.INK)
        self.assertAlmostEqual(ink.sum() / px_a_mm**2, sheets.MARK_MM**2, delta=0.1)


if __name__ == "__main__":
    unittest.main()
