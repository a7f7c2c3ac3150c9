"""Python's clients at a board that asks for keys.

keys_test.py PIZARRA-BOARD
"""

import asyncio
import os
import signal
import subprocess

import zmq

import a_board
from a_board import NOTE, PATIENCE, BoardTest, free_address
from pizarra import AsyncBoard, Board, Contract, Failure, Presence


class WithKeys(BoardTest):
    def start_board(self, address=None):
        self.address = free_address()
        self.make_key("board", "")
        self.make_key("desk", "(tell *) (take *) (read *)")
        self.make_key("camera", "(tell agent contract request reply) (read agent contract)")
        self.server = subprocess.Popen([a_board.program, "--listen", self.address, "--keys", self.folder], stdout=subprocess.DEVNULL)
        self.addCleanup(a_board.end, self.server, signal.SIGTERM)

    def make_key(self, name, permissions):
        public, secret = (key.decode() for key in zmq.curve_keypair())
        with open(self.secret(name), "w", encoding="utf-8", opener=lambda path, flags: os.open(path, flags, 0o600)) as file:
            file.write(f'(secret-key {name} "{public}" "{secret}")')
        with open(os.path.join(self.folder, f"{name}.key"), "w", encoding="utf-8") as file:
            file.write(f'(key {name} "{public}" {permissions})')

    def secret(self, name):
        return os.path.join(self.folder, f"{name}.secret")

    def test_a_client_is_called_by_its_key(self):
        with self.client(key=self.secret("desk")) as board:
            board.declare(NOTE)
            board.tell("(note 1 a)")
            self.assertEqual(board.pull("(note 1 ?)").teller, "desk/script")

    def test_without_a_key_or_with_one_that_is_not_known_nothing_is_permitted(self):
        self.make_key("stranger", "(tell *)")
        os.remove(os.path.join(self.folder, "stranger.key"))
        with self.client(key=self.secret("desk")) as board:
            board.declare(NOTE)  # it is there, and lets in whom it knows
        for options in ({}, {"key": self.secret("stranger")}):
            with self.client(**options) as board:
                self.refused("not-permitted", board.ask, "(note ? ?)")

        async def ask():
            async with AsyncBoard(self.address, "loop", timeout=PATIENCE) as board:
                await board.ask("(note ? ?)")
        with self.assertRaises(Failure) as caught:
            asyncio.run(ask())
        self.assertEqual(caught.exception.symbol, "not-permitted")

    def test_an_agent_comes_whose_key_does_not_let_it_be_bound_by_its_name(self):
        with Board(self.address, "camera", key=self.secret("camera"), timeout=PATIENCE) as board:
            presence = Presence("camera", Contract("camera", offers=["(look)"]))
            board.run(presence.come())
            self.assertEqual(len(board.ask("(agent camera camera ?)")), 1)
            self.refused("not-permitted", board.ask, "(note ? ?)")


a_board.run(__name__)
