"""The example that plots a grasp, beside a cell that runs: python_plot_test.py PIZARRA-CELL SOURCE-DIR

Ends with 77, and says why, where matplotlib is not installed.
"""

import importlib.util
import os
import subprocess
import sys
import unittest

if importlib.util.find_spec("matplotlib") is None:
    print("skipped: python3-matplotlib is not installed")
    sys.exit(77)

from running_cell import CellTest


class ThePlotOfAGrasp(CellTest):
    def plot(self, *words):
        return subprocess.run(self.example("12-python-plot/grasp.py", *words), cwd=self.folder, env=self.environment,
                              capture_output=True, text=True, check=False)

    def test_a_grasp_is_plotted(self):
        picture = os.path.join(self.folder, "grasp.png")
        plotted = self.plot(self.start_cell(), "circle", "--out", picture, "--patience", "300")
        self.assertEqual(plotted.returncode, 0, plotted.stderr)
        self.assertRegex(plotted.stdout, r"^the goal is \w+ after \d+ looks\n")
        from matplotlib import image
        drawn = image.imread(picture)
        self.assertEqual(drawn.shape[:2], (600, 800))
        blue = (drawn[:, :, 2] > drawn[:, :, 0] + 0.3).nonzero()[0]
        self.assertTrue((blue < 300).any() and (blue > 300).any(), "a curve in each half")

    def test_what_cannot_be_plotted_says_why(self):
        for words, status, sentence in (([], 2, "BOARD-ADDRESS"), (["nowhere"], 1, "grasp: bad-address")):
            plotted = self.plot(*words)
            self.assertEqual(plotted.returncode, status)
            self.assertIn(sentence, plotted.stderr)


unittest.main()
