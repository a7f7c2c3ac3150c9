"""Replicas: what is asked of a relation that is held here is answered as the board would, and without it.

replica_test.py PIZARRA-BOARD
"""

import asyncio
import random

import a_board
from a_board import PATIENCE, BoardTest
from pizarra import AsyncBoard, Symbol, retract, tell

NUMBER = "(relation number ((name symbol) (value integer) (owner symbol)) (key name))"
OTHER = "(relation other ((name symbol)))"


def number(name, value, owner="me"):
    return [Symbol("number"), Symbol(f"n{name}"), value, Symbol(owner)]


def said(answers):
    return [[(fact.id, fact.datum, fact.teller, fact.because) for fact in answer.facts] for answer in answers]


class ReplicaTest(BoardTest):
    def setUp(self):
        super().setUp()
        self.writer, self.holder = self.client("writer"), self.client("holder")
        self.writer.declare(NUMBER, OTHER)

    def asked_here(self, query):
        """The answers, where the board is not asked."""
        sent = []
        link, send = self.holder.session.link, self.holder.session.link.send
        link.send = lambda text: sent.append(text) or send(text)
        try:
            answers = self.holder.ask(query)
        finally:
            del link.send
        return None if any("(ask" in text for text in sent) else answers

    def test_a_pattern_is_answered_without_the_board(self):
        revision = self.writer.tell(number(1, 5))
        self.holder.replicate(NUMBER)
        [answer] = self.asked_here("(number n1 ?v ?)")
        self.assertEqual(answer.bindings["?v"], 5)
        self.assertEqual(answer.facts[0].teller, "writer")
        self.assertGreaterEqual(self.holder.revision, revision)

    def test_what_is_not_held_or_cannot_be_asked_goes_to_the_board(self):
        self.holder.replicate(NUMBER)
        self.holder.transact([tell(number(1, 5)), tell("(other n1)")])
        for query in ("(other ?n)", "(and (number ?n ?v ?) (not (other ?n)))", "(query (number ?n ?v ?) (limit 1))",
                      "(and (number ?n ?v ?) (other ?n))"):
            self.assertIsNone(self.asked_here(query), query)
        for query in ("(number 5 ?v ?)", "(number ?n ?v)", "(and (number ?n ?v ?o) (number ?n ?v))"):
            here = self.refused("wrong-shape", self.holder.ask, query)
            self.assertEqual(str(here), str(self.refused("wrong-shape", self.writer.ask, query)))
        for query in ("(and (< ?v 3) (number ?n ?v ?))", "(and (number ?n ?v ?) (< ?n x))", "(and (number ?n ?v ?) (< ?v))",
                      "(and)", "(and (number ?n ?v ?) 5)"):
            here = self.refused("bad-query", self.holder.ask, query)
            self.assertEqual(str(here), str(self.refused("bad-query", self.writer.ask, query)))

    def test_a_relation_larger_than_a_message_is_held_whole(self):
        for first in range(0, 20_000, 1000):
            self.writer.transact([tell(number(n, n)) for n in range(first, first + 1000)])
        self.holder.replicate(NUMBER)
        for n in (0, 1, 9_999, 19_999):
            [answer] = self.asked_here(f"(number n{n} ?v ?)")
            self.assertEqual(answer.bindings["?v"], n)
        self.assertEqual(len(self.asked_here("(number ?n ?v ?)")), 20_000)

    def test_it_answers_what_the_board_answers(self):
        seed = 5
        chance = random.Random(seed)
        self.holder.replicate(NUMBER)
        here = 0
        questions = ("(number ?n ?v ?o)", "(number n3 ?v ?o)", "(number ?n 3 ?o)", "(number ?n ?v a)", "(number ?x ?v ?x)",
                     "(and (number ?n ?v ?o) (> ?v 2) (/= ?o b))", "(and (number ?n ?v a) (number ?m ?v b))",
                     "(and (number ?n ?v ?o) (not (number ?m ?v b)))", "(and (number ?n ?v ?) (number ?m ?w ?) (< ?v ?w))",
                     "(not (number ?n 3 a))", "(and (number ?n ?v ?o) (= ?v 3.0))", "(and (number ?n ?v ?o) (= ?n ?o))")
        for round in range(200):
            steps = [tell(number(chance.randrange(8), chance.randrange(6), chance.choice("ab"))) for _ in range(5)]
            self.writer.transact(steps + [retract([Symbol("number"), Symbol(f"n{chance.randrange(8)}"), Symbol("?"), Symbol("a")])])
            self.holder.tell(number(100, round))  # its own write brings it up to date
            question = chance.choice(questions)
            answers = self.asked_here(question)
            here += answers is not None
            with self.subTest(seed=seed, round=round, question=question):
                self.assertEqual(said(self.holder.ask(question) if answers is None else answers), said(self.writer.ask(question)))
        self.assertGreater(here, 100, "it need not ask, as a rule")

    def test_after_the_board_was_lost_it_holds_what_the_next_one_has(self):
        self.holder.replicate(NUMBER)
        self.holder.tell(number(1, 5))
        self.restart_board()
        self.writer.declare(NUMBER, OTHER)
        self.writer.tell(number(2, 7))
        self.until(lambda: [answer.bindings["?n"] for answer in self.asked_here("(number ?n ?v ?)") or []] == [Symbol("n2")])

    def test_many_writers_of_asyncio_read_their_own_writes_among_others(self):
        async def write_and_read(own):
            chance = random.Random(own)
            async with AsyncBoard(self.address, f"w{own}", timeout=PATIENCE) as board:
                await board.replicate(NUMBER)
                for round in range(1, 60):
                    await board.tell(number(100 + chance.randrange(4), round))
                    revision = await board.tell(number(own, round))
                    seen = await board.ask(f"(number n{own} ?v ?)")
                    self.assertEqual([answer.bindings["?v"] for answer in seen], [round])
                    self.assertGreaterEqual(seen.revision, revision)

        async def all_of_them():
            await asyncio.gather(*map(write_and_read, range(4)))
        asyncio.run(all_of_them())


a_board.run(__name__)
