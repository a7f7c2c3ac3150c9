"""What python_client.cpp measures of Python: prints one number.

    python_client.py BOARD plain|asyncio trip|facts TRIPS BATCH BATCHES
"""

import asyncio
import statistics
import sys
import time

from pizarra import AsyncBoard, Board, Symbol, tell

address, client, what = sys.argv[1:4]
trips, batch, batches = map(int, sys.argv[4:])


def fact(object, count):
    return [Symbol("seen"), f"object-{object:06}", 100.25 + count % 100, 87.5, count % 10_000]


def transactions():
    return ([tell(fact(object, number)) for object in range(batch)] for number in range(batches))


def plain_trip(board):
    took = []
    for count in range(trips):
        begun = time.perf_counter()
        board.tell(fact(count % batch, count))
        took.append(time.perf_counter() - begun)
    return statistics.median(took) * 1e6


def plain_facts(board):
    begun = time.perf_counter()
    for steps in transactions():
        board.transact(steps)
    return batch * batches / (time.perf_counter() - begun)


async def asyncio_trip(board):
    took = []
    for count in range(trips):
        begun = time.perf_counter()
        await board.tell(fact(count % batch, count))
        took.append(time.perf_counter() - begun)
    return statistics.median(took) * 1e6


async def asyncio_facts(board):
    begun = time.perf_counter()
    for steps in transactions():
        await board.transact(steps)
    return batch * batches / (time.perf_counter() - begun)


async def in_a_loop(measure):
    async with AsyncBoard(address, "python") as board:
        await board.lease(1)  # it has come
        return await measure(board)


if client == "plain":
    with Board(address, "python") as board:
        board.lease(1)
        print({"trip": plain_trip, "facts": plain_facts}[what](board), flush=True)
else:
    print(asyncio.run(in_a_loop({"trip": asyncio_trip, "facts": asyncio_facts}[what])), flush=True)
