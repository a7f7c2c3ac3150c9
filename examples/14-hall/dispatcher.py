"""Gives the jobs of a hall to its cells: a coordinator above coordinators.

    python3 dispatcher.py HALL-BOARD [--key FILE]

The hall's board names the cells, as `pizarra contexts --add` has it, and somebody tells it jobs:

    (job N (FORM ...))                   a goal for any cell; durable
    (job-state N STATE CELL DETAIL)      STATE given, reached or failed; durable

A job goes to a cell that has none in hand and whose coordinator is there. Where the cell refuses it or fails, it goes
to the next one. Half a minute is waited for cells that are away. A job that every cell has had in vain is failed, and
its DETAIL says why the last one failed. Of a job that is given, DETAIL is the number of the goal that the cell had
before. So a dispatcher that is started again knows the goal that the one before it gave, and gives none twice.
"""

import argparse
import asyncio
import time

from pizarra import AsyncBoard, Failure, Symbol

JOB = "(relation job ((n integer) (goal list)) (key n) (durable))"
STATE = "(relation job-state ((n integer) (state symbol) (cell symbol) (detail datum)) (key n) (durable))"
CELL = "(relation context-board ((name symbol) (address string)) (key name) (durable))"
WORD = {state: Symbol(state) for state in ("given", "reached", "failed", "none", "kept")}


class Cell:
    """One cell, over the board that is its own."""

    PATIENCE = 600.0  # of a goal, in seconds
    LAPSED = 5.0      # what a client asked for that died has been taken by then, or is gone

    def __init__(self, name, address, key):
        self.name, self.address, self._key = name, address, key
        self.is_busy = False

    async def is_there(self):
        try:
            async with AsyncBoard(self.address, "dispatcher", self._key) as board:
                await board.server("coordinator")
                return True
        except Failure:
            return False

    async def newest(self):
        """The number of the cell's newest goal: those after it are ours, where they have our forms."""
        async with AsyncBoard(self.address, "dispatcher", self._key) as board:
            return max((number for number, _ in await self._goals(board)), default=0)

    async def build(self, forms, since, may_be_given):
        """How the goal ended there: its state, and its detail."""
        async with AsyncBoard(self.address, "dispatcher", self._key) as board:
            if may_be_given:
                await asyncio.sleep(self.LAPSED)
            given = [number for number, goal in await self._goals(board) if number > since and goal == forms]
            if not given:
                given = await board.request(await board.server("coordinator"), [Symbol("goal"), *forms], timeout=30)
            ended = await board.await_answer(f"(and (goal-state {given[0]} ?state ?detail) (/= ?state running))",
                                             self.PATIENCE)
            return ended.bindings["?state"], ended.bindings["?detail"]

    @staticmethod
    async def _goals(board):
        try:
            return [(a.bindings["?n"], a.bindings["?forms"]) for a in await board.ask("(goal ?n ?forms)")]
        except Failure as failure:
            if failure.symbol != "undeclared-relation":
                raise
            return []


class Dispatcher:
    LOOK = 0.5    # seconds
    AWAY = 30.0   # so long a job waits for cells that are away

    def __init__(self, hall, key):
        self._hall, self._key = hall, key
        self._cells = {}
        self._in_hand = {}  # the task of each job

    async def run(self):
        await self._hall.declare(JOB, STATE, CELL)
        while True:
            try:
                await self._look()
            except Failure as failure:
                if failure.symbol not in ("unreachable", "unavailable"):
                    raise
            await asyncio.sleep(self.LOOK)

    async def _look(self):
        for answer in await self._hall.ask("(context-board ?name ?address)"):
            name, address = answer.bindings["?name"], answer.bindings["?address"]
            if name not in self._cells or self._cells[name].address != address:
                self._cells[name] = Cell(name, address, self._key)
        ended = {a.bindings["?n"] for a in await self._hall.ask("(job-state ?n ?state ? ?)")
                 if a.bindings["?state"] in (WORD["reached"], WORD["failed"])}
        for answer in await self._hall.ask("(query (job ?n ?goal) (order ?n))"):
            number, goal = answer.bindings["?n"], answer.bindings["?goal"]
            running = self._in_hand.get(number)
            if running and running.done():
                running.result()  # a fault of our own ends the program
            if number not in ended and (running is None or running.done()):
                self._in_hand[number] = asyncio.ensure_future(self._carry_out(number, goal))

    async def _carry_out(self, number, goal):
        tried, why = set(), ()
        while not self._cells:
            await asyncio.sleep(self.LOOK)
        given = await self._hall.ask(f"(job-state {number} given ?cell ?since)")
        before = given[0].bindings if given else {}
        while len(tried) < len(self._cells):
            cell = await self._take_free_cell(tried, before.get("?cell"))
            tried.add(cell.name)
            try:
                was_given = before.get("?cell") == cell.name
                since = before["?since"] if was_given else await cell.newest()
                await self._say(number, "given", cell.name, since)
                state, why = await cell.build(goal, since, was_given)
            except Failure as failure:
                state, why = WORD["failed"], [Symbol("fail"), Symbol(failure.symbol), failure.sentence]
            finally:
                cell.is_busy = False
            before = {}
            if state in (WORD["reached"], WORD["kept"]):
                return await self._say(number, "reached", cell.name)
        await self._say(number, "failed", WORD["none"], why)

    async def _take_free_cell(self, tried, given_to):
        until = time.monotonic() + self.AWAY
        while True:
            names = [given_to] if given_to in self._cells else [name for name in self._cells if name not in tried]
            for name in names:
                cell = self._cells[name]
                if cell.is_busy:
                    continue
                cell.is_busy = True
                if time.monotonic() > until or await cell.is_there():
                    return cell
                cell.is_busy = False
            await asyncio.sleep(self.LOOK)

    async def _say(self, number, state, cell, detail=()):
        fact = [Symbol("job-state"), number, WORD[state], cell, detail]
        while True:
            try:
                await self._hall.tell(fact)
                return print(f"job {number} is {state}: {cell}", flush=True)
            except Failure as failure:
                if failure.symbol not in ("unreachable", "unavailable"):
                    raise


async def main():
    parser = argparse.ArgumentParser(description="Gives the jobs of a hall to its cells.")
    parser.add_argument("board", metavar="HALL-BOARD", help="the address of the board that names the cells")
    parser.add_argument("--key", help="the secret key to come with, to the hall and to the cells")
    choices = parser.parse_args()
    async with AsyncBoard(choices.board, "dispatcher", choices.key) as hall:
        await Dispatcher(hall, choices.key).run()


if __name__ == "__main__":
    try:
        asyncio.run(main())
    except KeyboardInterrupt:
        pass
