"""Lets the behaviour tests of the walls drive Python's boards: a line in, a line out, each an s-expression.

    python_wall.py plain|asyncio

(ID VIEW OPERATION ARGUMENT ...) is answered by (ID (ok VALUE)) or (ID (fail SYMBOL SENTENCE SUBJECT)). An answer is
((FACT ...) ((VARIABLE VALUE) ...)).
"""

import asyncio
import os
import sys

import zmq

from pizarra import AsyncBoard, Board, Failure, Symbol, read, write

boards, watches = {}, {}


def fact_form(fact):
    return [fact.id, fact.revision, fact.microseconds, fact.teller, fact.datum, *fact.because]


def answer_form(answer):
    return [[fact_form(fact) for fact in answer.facts],
            [[Symbol(name), value] for name, value in answer.bindings.items()]]


def change_form(change):
    return [change.revision, Symbol("yes" if change.resynchronised else "no"),
            [answer_form(answer) for answer in change.added], [answer_form(answer) for answer in change.removed]]


# How an operation is called, and what is said of what it gives.
def say_ok(_):
    return []


OPERATIONS = {
    "declare": (lambda board, *relations: board.declare(*relations), say_ok),
    "transact": (lambda board, preconditions, steps: board.transact(steps, preconditions), int),
    "ask": (lambda board, query: board.ask(query),
            lambda answers: [answers.revision, *map(answer_form, answers)]),
    "take": (lambda board, pattern, lease: board.take(pattern, lease),
             lambda fact: [] if fact is None else [fact_form(fact)]),
    "lease": (lambda board, microseconds: board.lease(microseconds / 1e6), int),
    "renew": (lambda board, lease: board.renew(lease), say_ok),
    "release": (lambda board, lease: board.release(lease), say_ok),
}


def say(number, reply):
    try:
        print(write([number, reply]), flush=True)
    except BrokenPipeError:
        os._exit(0)  # the test is over


def fail_form(failure):
    return [Symbol("fail"), Symbol(failure.symbol), failure.sentence, failure.subject]


def lines_of_stdin():
    """Each call reads what has come and gives the whole lines; nothing more comes after None."""
    unread = b""
    while True:
        chunk = os.read(sys.stdin.fileno(), 1 << 20)
        if not chunk:
            yield None
        *lines, unread = (unread + chunk).split(b"\n")
        yield [read(line.decode()) for line in lines]


class Plain:
    """Boards of one thread, which takes turns with them."""

    def __init__(self):
        self.waiting = {}  # requests for a change, and their watches

    def perform(self, view, operation, *arguments):
        if operation == "open":
            address, teller, timeout = arguments
            boards[view] = Board(address, teller, timeout=timeout)
        elif operation == "close":
            boards.pop(view).close()
        elif operation == "watch":
            watches[arguments[1]] = boards[view].watch(arguments[0])
        elif operation == "unwatch":
            watches.pop(arguments[0]).close()
        else:
            call, form = OPERATIONS[operation]
            return form(call(boards[view], *arguments))
        return []

    def answer(self, number, outcome):
        """Whether there is an answer: an outcome of None is still to come."""
        try:
            value = outcome()
        except Failure as failure:
            say(number, fail_form(failure))
            return True
        if value is not None:
            say(number, [Symbol("ok"), value])
        return value is not None

    def next_change(self, watch):
        change = watch.poll()
        return change and change_form(change)

    def obey(self, number, view, operation, *arguments):
        if operation == Symbol("next"):
            self.waiting[number] = watches[arguments[0]]
        else:
            self.answer(number, lambda: self.perform(view, str(operation), *arguments))

    def run(self):
        lines, stdin = lines_of_stdin(), sys.stdin.fileno()
        while True:
            poller = zmq.Poller()
            poller.register(stdin, zmq.POLLIN)
            for board in boards.values():
                for socket in board.sockets():
                    poller.register(socket, zmq.POLLIN)
            if stdin in dict(poller.poll(50)):
                told = next(lines)
                if told is None:
                    return
                for line in told:
                    self.obey(*line)
            for board in boards.values():
                board.turn()
            for number, watch in list(self.waiting.items()):
                if watch not in watches.values() or self.answer(number, lambda: self.next_change(watch)):
                    del self.waiting[number]


class Asyncio:
    """Boards of one loop, whose calls are under way at once."""

    async def perform(self, view, operation, *arguments):
        if operation == "open":
            address, teller, timeout = arguments
            boards[view] = AsyncBoard(address, teller, timeout=timeout)
            await boards[view].__aenter__()
        elif operation == "close":
            await boards.pop(view).__aexit__()
        elif operation == "watch":
            watch = boards[view].watch(arguments[0])
            await watch.__aenter__()
            watches[arguments[1]] = watch
        elif operation == "unwatch":
            watches.pop(arguments[0]).close()
        elif operation == "next":
            return change_form(await watches[arguments[0]].next())
        else:
            call, form = OPERATIONS[operation]
            return form(await call(boards[view], *arguments))
        return []

    async def obey(self, number, view, operation, *arguments):
        try:
            say(number, [Symbol("ok"), await self.perform(view, str(operation), *arguments)])
        except Failure as failure:
            say(number, fail_form(failure))

    async def serve(self):
        lines, over, jobs = lines_of_stdin(), asyncio.Event(), set()
        loop = asyncio.get_running_loop()

        def come():
            told = next(lines)
            if told is None:
                loop.remove_reader(sys.stdin.fileno())
                over.set()
            for line in told or []:
                job = loop.create_task(self.obey(*line))
                jobs.add(job)
                job.add_done_callback(jobs.discard)
        loop.add_reader(sys.stdin.fileno(), come)
        await over.wait()
        for job in list(jobs):
            job.cancel()

    def run(self):
        asyncio.run(self.serve())


{"plain": Plain, "asyncio": Asyncio}[sys.argv[1]]().run()
