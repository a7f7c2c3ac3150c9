"""A cell that runs in a folder of its own while a test goes on.

    class ThePlot(CellTest):
        def test_...(self):
            address = self.start_cell()              # once everything is taught
            self.run_example("12-python-plot/grasp.py", address)

The program and the tree are the first two words of the test's command line.
"""

import os
import signal
import subprocess
import sys
import tempfile
import unittest

program, source = sys.argv[1:3]
del sys.argv[1:3]


class CellTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.environment = dict(os.environ, XDG_RUNTIME_DIR=self.folder, TMPDIR=self.folder, MPLCONFIGDIR=self.folder,
                                PYTHONPATH=os.path.join(source, "blackboard/python"))

    def start(self, words, **options):
        """Ended with the test."""
        process = subprocess.Popen(words, cwd=self.folder, env=self.environment, text=True, **options)
        self.addCleanup(process.wait)
        self.addCleanup(process.send_signal, signal.SIGINT)
        return process

    def start_cell(self):
        """Its board's address, once everything is taught."""
        subprocess.run([os.path.join(source, "tests/taught_cell"), program, self.folder], check=True)
        cell = self.start([program, "up", os.path.join(self.folder, "cell.scm")], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT)
        self.addCleanup(cell.stdout.close)
        said, address = [], None
        for line in cell.stdout:
            said.append(line)
            words = line.split()
            address = next((word for word in words if word.startswith("ipc://")), address)
            if "ready for goals" in line:
                return address
        self.fail("".join(said))

    def example(self, file, *words):
        """Its command line."""
        return [sys.executable, os.path.join(source, "examples", file), *words]
