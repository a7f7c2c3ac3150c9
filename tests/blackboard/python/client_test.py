"""What the Python client makes of what is no datum: a Failure at once, and nothing sent.

client_test.py PIZARRA-BOARD
"""

import math
import os
import socket
import tempfile
import time
import unittest

import zmq

import a_board
from a_board import NOTE, BoardTest
from pizarra import Board, Failure, Symbol, read, tell, write
from pizarra.session_requests import Requests


def nested(depth):
    datum = []
    for _ in range(depth):
        datum = [datum]
    return datum


class Data(unittest.TestCase):
    def refused(self, symbol, action, *arguments):
        with self.assertRaises(Failure) as caught:
            action(*arguments)
        self.assertEqual(caught.exception.symbol, symbol, (arguments, caught.exception))
        self.assertTrue(caught.exception.sentence)

    def test_what_is_no_datum_is_not_written(self):
        no_data = [2**63, -2**63 - 1, math.nan, math.inf, True, None, b"bytes", {"a": 1}, {1}, object(), "\0", "\ud800",
                   Symbol(""), Symbol("12"), Symbol("-.5"), Symbol("a b"), Symbol("'a"), Symbol("."), Symbol("\u00e9"),
                   Symbol("a\n")]
        for datum in no_data:
            self.refused("bad-datum", write, [Symbol("note"), 1, datum])
        self.refused("too-large", write, nested(3000))

    def test_what_is_a_datum_is_written_and_read_back(self):
        data = [2**63 - 1, -2**63, 0.1, -1e-7, 1e22, "", "\r\x01\t\n\"\\", "\u00e9\U0001f600", Symbol("nan"), Symbol("-"),
                Symbol("?x"), Symbol("..."), [], [[Symbol("a")], 1, "1"], nested(60)]
        for datum in data:
            self.assertEqual(read(write(datum)), datum)
            self.assertIs(type(read(write(datum))), type(datum))

    def test_what_the_board_would_not_read_is_not_read(self):
        texts = {"(n k 1.)": "bad-number", "(n k .5)": "bad-number", "(n k 1e999)": "bad-number", "1x": "bad-number",
                 "(n k 1e-999)": "bad-number", f"(n {2**63})": "bad-number", "9" * 5000: "bad-number",
                 "(n k 'a)": "bad-character", "(n . k)": "bad-character", "(n, k)": "bad-character", "\u0663": "bad-character",
                 "a\u00a0b": "bad-character", '"\0"': "bad-text", '"\ud800"': "bad-text", '"\\q"': "bad-escape",
                 '"open': "unclosed-string", "(open": "unclosed-list", ")": "unexpected-close", "a b": "more-than-one",
                 "": "nothing-to-read", " ; nothing": "nothing-to-read"}
        for text, symbol in texts.items():
            self.refused(symbol, read, text)


def free_port_of_ipv6():
    """None without IPv6."""
    try:
        with socket.create_server(("::1", 0), family=socket.AF_INET6) as server:
            return server.getsockname()[1]
    except OSError:
        return None


class OnABoard(BoardTest):
    def setUp(self):
        super().setUp()
        self.board = self.client()
        self.board.declare(NOTE)

    def refused(self, symbol, action, *arguments):
        began = time.monotonic()
        super().refused(symbol, action, *arguments)
        self.assertLess(time.monotonic() - began, a_board.PATIENCE / 2, "not when its patience ends")

    def test_a_board_at_an_address_of_ipv6_is_reached(self):
        port = free_port_of_ipv6()
        if port is None:
            self.skipTest("this machine has no IPv6")
        self.start_board("tcp://[::1]:%d" % port)

    def test_what_is_no_datum_is_refused_and_the_board_goes_on(self):
        for datum in (2**70, b"bytes", {}, "\r\x00\x01", None, "\ud800", Symbol("12")):
            self.refused("bad-datum", self.board.tell, [Symbol("note"), 1, datum])
        for text in ("(note 1 1.)", "(note 1 .5)", "(note 1 'a)", '(note 1 "\\q")'):
            self.assertRaises(Failure, self.board.tell, text)
        self.refused("too-large", self.board.tell, [Symbol("note"), 1, nested(3000)])
        self.refused("too-large", self.board.tell, [Symbol("note"), 1, [1] * 300_000])
        for seconds in (math.inf, math.nan, "1", None, 1e300):
            self.refused("wrong-shape", self.board.lease, seconds)
        for query in ("()", "42", [], 42, "(query)"):
            self.refused("bad-query", self.board.watch, query)
        self.board.tell((Symbol("note"), 1, ("\r\x01", 0.5)))
        [answer] = self.board.ask((Symbol("note"), 1, Symbol("?text")))
        self.assertEqual(answer.bindings, {"?text": ["\r\x01", 0.5]})

    def mangle(self, frame):
        """Sends this for each request."""
        link = self.board.session.link

        def send(text):
            if text.startswith("(request"):
                text = frame.format(session=self.board.session.id, number=text.split()[2])
            return type(link).send(link, text)
        link.send = send

    def test_what_the_board_cannot_read_fails_at_once(self):
        self.mangle("(request 1.")
        self.refused("bad-frame", self.board.tell, "(note 1 2)")

    def test_what_the_board_cannot_read_fails_alone_where_it_begins_like_a_request(self):
        self.mangle("(ping {session})")
        other = self.board.begin([Symbol("ask"), read("(note 1 ?)")], True)
        self.mangle("(request {session} {number} (tell 1.")
        self.refused("bad-frame", self.board.tell, "(note 1 2)")
        self.assertIsNone(other.result)

    def test_no_request_goes_far_ahead_of_one_that_is_not_answered(self):
        begun = [self.board.begin([Symbol("transact"), [], [tell(f"(note {n} 1)")]], False) for n in range(300)]
        self.assertEqual(sum(request.sent is not None for request in begun), Requests.MOST_AHEAD)
        deadline = time.monotonic() + 8
        while time.monotonic() < deadline and any(request.result is None for request in begun):
            self.board.turn(0.05)
        self.assertTrue(all(isinstance(request.result, list) for request in begun))
        self.assertEqual(len(self.board.ask("(note ?n 1)")), 300)

    def test_so_many_requests_are_under_way_and_no_more(self):
        begun = [self.board.begin([Symbol("ask"), read("(note ? ?)")], True) for _ in range(Requests.MOST_PENDING)]
        self.refused("too-large", self.board.ask, "(note ? ?)")
        self.until(lambda: self.board.turn(0.05) or all(request.result for request in begun))
        self.assertEqual(self.board.ask("(note ? ?)"), [])

    def test_a_closed_board_says_so(self):
        watch = self.board.watch("(note ?n ?)")
        self.board.tell("(note 1 2)")
        self.board.close()
        for action, arguments in ((self.board.ask, ["(note ?n ?)"]), (self.board.tell, ["(note 1 2)"]), (self.board.turn, []),
                                  (self.board.wait, [0.1]), (watch.next, [1]), (self.board.stream, ["vision-left"])):
            self.refused("closed", action, *arguments)
        watch.close()
        self.board.close()


class WhatABoardCannotBeginWith(unittest.TestCase):
    def refused(self, symbol, *arguments):
        with self.assertRaises(Failure) as caught:
            Board(*arguments)
        self.assertEqual(caught.exception.symbol, symbol, (arguments, caught.exception))

    def test_an_address_that_is_none(self):
        for address in ("", "nowhere", "tcp://", "tcp://here:port", "carrier-pigeon://x", "ipc://" + "x" * 200):
            self.refused("bad-address", address, "script")
        self.refused("wrong-shape", None, "script")
        self.refused("wrong-shape", "ipc:///tmp/none", 1)

    def test_a_name_that_is_none(self):
        for name in ("my script", "", "9th", "?x", "a(b", "a\nb", "caf\u00e9", ".", "\ud800"):
            self.refused("bad-name", "ipc:///tmp/none", name)
        self.refused("too-large", "ipc:///tmp/none", "x" * 129)
        Board("ipc:///tmp/none", "x" * 128).close()

    def test_keys_that_are_none(self):
        with tempfile.TemporaryDirectory() as folder:
            secret, board = os.path.join(folder, "me.secret"), os.path.join(folder, "board.key")
            self.refused("unreadable-file", "tcp://127.0.0.1:9", "me", secret)
            self.refused("unreadable-file", "tcp://127.0.0.1:9", "me", folder)
            public, own = zmq.curve_keypair()
            whole = f'(secret-key me "{public.decode()}" "{own.decode()}")'
            for junk in (b"", b"junk", b"(junk)", b"(secret-key)", b"\xff\xfe", b"(", b'(secret-key me "a" "b")',
                         f'(secret-key me "{"#" * 40}" "{"#" * 40}")'.encode(), b"(secret-key me 1 2)",
                         b"(secret-key me (1) 2)", whole.replace("secret-", "").encode()):
                with open(secret, "wb", opener=lambda path, flags: os.open(path, flags, 0o600)) as file:
                    file.write(junk)
                self.refused("bad-key", "tcp://127.0.0.1:9", "me", secret)
            with open(secret, "w", encoding="utf-8") as file:
                file.write(whole)
            self.refused("unreadable-file", "tcp://127.0.0.1:9", "me", secret)
            with open(board, "w", encoding="utf-8") as file:
                file.write("(key board)")
            self.refused("bad-key", "tcp://127.0.0.1:9", "me", secret)
            with open(board, "w", encoding="utf-8") as file:
                file.write(f'(key board "{public.decode()}")')
            os.chmod(secret, 0o644)
            self.refused("exposed-key", "tcp://127.0.0.1:9", "me", secret)
            os.chmod(secret, 0o600)
            Board("tcp://127.0.0.1:9", "me", secret).close()


a_board.run(__name__)
