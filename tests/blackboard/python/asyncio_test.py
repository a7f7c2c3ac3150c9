"""Python's client for asyncio, beyond what the walls' behaviour tests ask of it.

asyncio_test.py PIZARRA-BOARD
"""

import asyncio

import a_board
from a_board import NOTE, PATIENCE, BoardTest
from pizarra import AsyncBoard, Failure, Symbol


def told_to(coroutine):
    """A test whose body is a coroutine, with a board."""
    def test(self):
        async def whole():
            async with AsyncBoard(self.address, "loop", timeout=PATIENCE) as board:
                await board.declare(NOTE)
                await asyncio.wait_for(coroutine(self, board), 2 * PATIENCE)
        asyncio.run(whole())
    return test


class ManyAtOnce(BoardTest):
    @told_to
    async def test_each_of_a_thousand_requests_has_its_own_answer(self, board):
        async def work(n):
            await board.tell([Symbol("note"), n, str(n)])
            [answer] = await board.ask([Symbol("note"), n, Symbol("?text")])
            return answer.bindings["?text"]
        self.assertEqual(await asyncio.gather(*map(work, range(1000))), [str(n) for n in range(1000)])

    @told_to
    async def test_a_request_that_nobody_awaits_any_more_is_forgotten(self, board):
        asking = asyncio.ensure_future(board.event("(note 1 ?)", timeout=PATIENCE))
        await board.ask("(note ? ?)")
        asking.cancel()
        with self.assertRaises(asyncio.CancelledError):
            await asking
        await board.tell("(note 1 a)")
        self.assertEqual(len(await board.ask("(note ? ?)")), 1, "it is not taken")
        self.assertEqual(board.session.feeds, {})


class AWatchAsIterator(BoardTest):
    @told_to
    async def test_it_gives_what_holds_and_then_every_change_in_order(self, board):
        await board.tell("(note 0 a)")
        seen = []

        async def tell_all():
            for n in range(1, 50):
                await board.tell([Symbol("note"), n, "a"])
        telling = asyncio.ensure_future(tell_all())
        async with board.watch("(note ?n ?)") as watch:
            async for change in watch:
                seen += [answer.bindings["?n"] for answer in change.added]
                if len(seen) >= 50:
                    break
        await telling
        self.assertEqual(seen, list(range(50)))

    @told_to
    async def test_a_board_that_is_started_again_resynchronises_it(self, board):
        await board.tell("(note 1 before)")
        async with board.watch("(note ?n ?text)") as watch:
            changes = watch.__aiter__()
            self.assertEqual((await changes.__anext__()).added[0].bindings["?n"], 1)
            self.restart_board()
            change = await changes.__anext__()
            self.assertTrue(change.resynchronised)
            self.assertEqual(change.added, [], "the next board is empty")
            await board.tell("(note 2 after)")
            change = await changes.__anext__()
            self.assertFalse(change.resynchronised)
            self.assertEqual(change.added[0].bindings, {"?n": 2, "?text": Symbol("after")})

    @told_to
    async def test_a_watch_that_reads_too_slowly_is_told_so_and_loses_nothing(self, board):
        with self.client() as teller:
            async with board.watch("(note ?n ?)") as watch:
                await watch.next(PATIENCE)
                for n in range(3000):
                    teller.tell([Symbol("note"), n, "x" * 100])
                known, resynchronised = {}, 0
                while len(known) < 3000:
                    change = await watch.next(PATIENCE)
                    if change.resynchronised:
                        known, resynchronised = {}, resynchronised + 1
                    known.update((answer.bindings["?n"], True) for answer in change.added)
                self.assertGreater(resynchronised, 0)

    @told_to
    async def test_what_the_board_refuses_is_raised_where_it_is_awaited(self, board):
        with self.assertRaises(Failure) as caught:
            async with board.watch("(nothing ?x)"):
                pass
        self.assertEqual(caught.exception.symbol, "undeclared-relation")
        with self.assertRaises(Failure) as caught:
            async for _ in board.watch("(nothing ?x)"):
                pass
        self.assertEqual(caught.exception.symbol, "undeclared-relation")
        with self.assertRaises(Failure) as caught:
            board.watch("()")
        self.assertEqual(caught.exception.symbol, "bad-query")


class ItsEnd(BoardTest):
    @told_to
    async def test_whoever_waits_is_told_of_the_end(self, board):
        other = AsyncBoard(self.address, "other")
        with self.assertRaises(Failure):
            await other.ask("(note ? ?)")
        await other.__aenter__()
        waiting = asyncio.ensure_future(other.event("(note ? ?)", timeout=PATIENCE))
        await other.ask("(note ? ?)")
        await other.__aexit__()
        with self.assertRaises(Failure) as caught:
            await waiting
        self.assertEqual(caught.exception.symbol, "closed")

    def test_without_a_board_everything_is_unreachable_after_the_timeout(self):
        async def ask():
            async with AsyncBoard("ipc:///tmp/none-at-all", "loop", timeout=0.2) as board:
                await board.ask("(note ? ?)")
        with self.assertRaises(Failure) as caught:
            asyncio.run(ask())
        self.assertEqual(caught.exception.symbol, "unreachable")


a_board.run(__name__)
