"""Several addresses: the client finds the board that answers, and goes on at another one when it is killed.

Boards that share a log are tried with it in cluster/boards_test.cpp; these two know nothing of each other.

boards_test.py PIZARRA-BOARD
"""

import asyncio
import os
import signal
import time

import a_board
from a_board import NOTE, PATIENCE, BoardTest, free_address
from pizarra import AsyncBoard, Board
from pizarra.session import Session


class SeveralBoards(BoardTest):
    def setUp(self):
        self.addresses = [free_address(), free_address()]
        self.address = ",".join(self.addresses)

    def test_the_second_is_found_where_the_first_is_not_there(self):
        self.start_board(self.addresses[1])
        with self.client() as board:
            board.declare(NOTE)
            board.tell("(note 1 a)")

    def test_a_watch_is_resynchronised_at_the_next_board_when_one_is_killed(self):
        first = self.start_board(self.addresses[0])
        with self.client() as board:
            board.declare(NOTE)
            board.tell("(note 1 a)")
            watch = board.watch("(note ?n ?)")
            self.assertEqual(watch.next(PATIENCE).added[0].bindings["?n"], 1)
            self.start_board(self.addresses[1])
            a_board.end(first, signal.SIGKILL)
            change = watch.next(PATIENCE)
            self.assertTrue(change.resynchronised)
            self.assertEqual(change.added, [], "the other board has other facts")
            board.tell("(note 2 a)")
            self.assertEqual(watch.next(PATIENCE).added[0].bindings["?n"], 2)

    def test_who_was_busy_with_something_else_does_not_take_the_board_for_gone(self):
        self.start_board(self.addresses[0])
        with self.client() as board:
            board.declare(NOTE)
            time.sleep(3 * Session.SILENCE_AMONG_OTHERS)
            board.turn()
            self.assertTrue(board.session.joined)
            self.assertEqual(board.ask("(note ? ?)"), [])

    def test_so_it_is_in_asyncio_back_and_forth(self):
        async def follow():
            server = self.start_board(self.addresses[0])
            async with AsyncBoard(self.address, "loop", timeout=PATIENCE) as board:
                await board.declare(NOTE)
                async with board.watch("(note ?n ?)") as watch:
                    self.assertEqual((await watch.next(PATIENCE)).added, [])
                    for n in (1, 0, 1):
                        a_board.end(server, signal.SIGKILL)
                        server = self.start_board(self.addresses[n])
                        self.assertTrue((await watch.next(PATIENCE)).resynchronised)
                        await board.tell(f"(note {n} a)")
                        change = await watch.next(PATIENCE)
                        self.assertEqual(change.added[0].bindings["?n"], n)
        asyncio.run(follow())

    def test_a_path_may_have_a_comma(self):
        folder = os.path.join(os.environ.get("TMPDIR", "/tmp"), f"pizarra,{os.getpid()}")
        os.mkdir(folder)
        self.addCleanup(os.rmdir, folder)
        self.address = f"ipc://{folder}/board"
        server = self.start_board()
        with Board(self.address, "script", timeout=PATIENCE) as board:
            board.declare(NOTE)
        a_board.end(server, signal.SIGTERM)


a_board.run(__name__)
