"""Lets the behaviour tests of the walls drive Python's Board: a line in, a line out, each an s-expression.

(ID VIEW OPERATION ARGUMENT ...) is answered by (ID (ok VALUE)) or (ID (fail SYMBOL SENTENCE SUBJECT)). An answer is
((FACT ...) ((VARIABLE VALUE) ...)).
"""

import os
import sys

import zmq

from pizarra import Board, Failure, Symbol, read, write

boards, watches, waiting = {}, {}, {}
poller = zmq.Poller()


def fact_form(fact):
    return [fact.id, fact.revision, fact.microseconds, fact.teller, fact.datum, *fact.because]


def answer_form(answer):
    return [[fact_form(fact) for fact in answer.facts],
            [[Symbol(name), value] for name, value in answer.bindings.items()]]


def change_form(change):
    return [change.revision, Symbol("yes" if change.resynchronised else "no"),
            [answer_form(answer) for answer in change.added], [answer_form(answer) for answer in change.removed]]


def perform(view, operation, *arguments):
    if operation == "open":
        boards[view] = Board(*arguments)
        for socket in boards[view].sockets():
            poller.register(socket, zmq.POLLIN)
        return []
    board = boards[view]
    if operation == "close":
        for socket in board.sockets():
            poller.unregister(socket)
        boards.pop(view).close()
        return []
    if operation == "declare":
        board.declare(*arguments)
        return []
    if operation == "transact":
        return board.transact(steps=arguments[1], preconditions=arguments[0])
    if operation == "ask":
        answers = [answer_form(answer) for answer in board.ask(arguments[0])]
        return [board.revision, *answers]
    if operation == "watch":
        watches[arguments[1]] = board.watch(arguments[0])
        return []
    if operation == "unwatch":
        watches.pop(arguments[0]).close()
        return []
    if operation == "take":
        fact = board.take(*arguments)
        return [] if fact is None else [fact_form(fact)]
    if operation == "lease":
        return board.lease(arguments[0] / 1e6)
    return getattr(board, operation)(*arguments) or []


def answer(number, outcome):
    """Whether there is an answer: an outcome of None is still to come."""
    try:
        value = outcome()
        reply = [Symbol("ok"), value]
    except Failure as failure:
        value = reply = [Symbol("fail"), Symbol(failure.symbol), failure.sentence, failure.subject]
    if value is not None:
        print(write([number, reply]), flush=True)
    return value is not None


def next_change(watch):
    change = watch.poll()
    return change and change_form(change)


def obey(line):
    number, view, operation, *arguments = read(line)
    if operation == Symbol("next"):
        waiting[number] = watches[arguments[0]]
    else:
        answer(number, lambda: perform(view, str(operation), *arguments))


def main():
    stdin = sys.stdin.fileno()
    poller.register(stdin, zmq.POLLIN)
    unread = b""
    while True:
        if stdin in dict(poller.poll(50)):
            chunk = os.read(stdin, 1 << 20)
            if not chunk:
                return
            *lines, unread = (unread + chunk).split(b"\n")
            for line in lines:
                obey(line.decode())
        for board in boards.values():
            board.turn()
        for number, watch in list(waiting.items()):
            if watch not in watches.values() or answer(number, lambda: next_change(watch)):
                del waiting[number]


try:
    main()
except BrokenPipeError:
    os._exit(0)  # the test is over
