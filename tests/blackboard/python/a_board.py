"""A board program for a test, and an agent beside it.

    class Things(BoardTest):
        def test_it(self):
            with self.client("script") as board: ...

The board program is the first word of the command line: run(__name__) takes it away.
"""

import os
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest

from pizarra import Board, Failure

NOTE = "(relation note ((n integer) (text datum)) (key n))"
PATIENCE = 30  # of whoever waits for what must come


class BoardTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.address = "ipc://" + os.path.join(self.folder, "board")
        self.start_board()

    def start_board(self, address=None):
        """Returns when it answers."""
        address = address or self.address
        server = subprocess.Popen([program, "--listen", address], stdout=subprocess.DEVNULL)
        self.addCleanup(end, server, signal.SIGTERM)
        with Board(address, "first", timeout=PATIENCE) as board:
            board.lease(1)
        self.server = server
        return server

    def restart_board(self):
        end(self.server, signal.SIGKILL)
        self.start_board()

    def client(self, name="script", **options):
        board = Board(self.address, name, timeout=PATIENCE, **options)
        self.addCleanup(board.close)
        return board

    def refused(self, symbol, action, *arguments):
        with self.assertRaises(Failure) as caught:
            action(*arguments)
        self.assertEqual(caught.exception.symbol, symbol, caught.exception)
        self.assertTrue(caught.exception.sentence)
        return caught.exception

    def until(self, holds):
        """Waits for what must come to hold."""
        deadline = time.monotonic() + PATIENCE
        while not holds():
            self.assertLess(time.monotonic(), deadline, "it does not come to hold")
            time.sleep(0.02)


def free_address():
    with socket.socket() as found:
        found.bind(("127.0.0.1", 0))
        return f"tcp://127.0.0.1:{found.getsockname()[1]}"


def end(process, number):
    if process.poll() is None:
        process.send_signal(number)
    process.wait()


def run(module):
    global program
    program = sys.argv.pop(1)
    if module == "__main__":
        unittest.main()
