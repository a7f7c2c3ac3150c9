"""Plots how the visual servo closes in on an object: Err_X and Err_D from the first look to the grasp.

    ./pizarra up examples/01-blocks/cell.scm                    in another terminal; it prints the board's address
    python3 grasp.py BOARD-ADDRESS [OBJECT] [--out grasp.png]

It needs Debian's python3-matplotlib. A part that begins with `# %%` is a cell, in an editor that knows notebooks.
"""

# %% Where the cell is, and what is grasped
import argparse
import asyncio
import sys

import matplotlib

matplotlib.use("Agg")  # into a file; leave this out to see a window
from matplotlib import pyplot

from pizarra import AsyncBoard, Failure, Symbol

parser = argparse.ArgumentParser(description="Has the cell grasp an object, and plots the servo's errors meanwhile.")
parser.add_argument("board", metavar="BOARD-ADDRESS", help="as `pizarra ps` shows it")
parser.add_argument("object", nargs="?", default="circle", help="circle otherwise")
parser.add_argument("--out", default="grasp.png", help="the picture; grasp.png otherwise")
parser.add_argument("--patience", type=float, default=120, help="seconds until the goal has ended; 120 otherwise")
choices = parser.parse_args()


# %% Give the goal, and keep what the servo says until the goal has ended
async def grasp():
    """The facts (servo STATE OBJECT ERR-X ERR-Y ERR-D), one a look, whose looks, and how the goal ended."""
    looks = []
    async with AsyncBoard(choices.board, "plotter") as board:

        async def follow():
            async for change in board.watch([*map(Symbol, ("servo", "?state", choices.object, "?x", "?y", "?d"))]):
                looks.extend(answer.facts[0] for answer in change.added)

        following = asyncio.create_task(follow())
        goal = [Symbol("goal"), [Symbol("holding"), Symbol(choices.object)]]
        [number] = await board.request(await board.server("coordinator"), goal)
        ended = await board.await_answer(f"(and (goal-state {number} ?state ?) (/= ?state running))", choices.patience)
        following.cancel()
        eyes = await board.holder("coordinator", "eyes")
        return looks, eyes.server, ended.bindings["?state"]


try:
    looks, eyes, state = asyncio.run(grasp())
except Failure as failure:
    sys.exit(f"grasp: {failure}")
print(f"the goal is {state} after {len(looks)} looks")
if not looks:
    sys.exit("grasp: the servo said nothing of it")

# %% Draw
seconds = [(fact.microseconds - looks[0].microseconds) / 1e6 for fact in looks]
figure, (left, right) = pyplot.subplots(2, sharex=True, figsize=(8, 6))
for axes, place, name in ((left, 3, "Err_X, pixels"), (right, 5, "Err_D, mm")):
    axes.axhline(0, color="0.7", linewidth=1)
    axes.plot(seconds, [fact.datum[place] for fact in looks], ".-")
    axes.set_ylabel(name)
right.set_xlabel("seconds since the first look")
left.set_title(f"Grasping {choices.object} by what {eyes} sees: the goal is {state}")
figure.savefig(choices.out)
print(choices.out)
