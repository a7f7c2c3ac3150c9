"""asker.py TREE BOARD COUNT: how many milliseconds each of so many questions to the board takes, and as many to the arm,
as JSON."""

import json
import sys
import time

sys.path.insert(0, sys.argv[1] + "/blackboard/python")
from pizarra import Board  # noqa: E402


def took(question):
    begun = time.perf_counter()
    question()
    return (time.perf_counter() - begun) * 1e3


times = {"board": [], "arm": []}
with Board(sys.argv[2], "asker") as board:
    for _ in range(int(sys.argv[3])):
        times["board"].append(took(lambda: board.ask("(agent ?name ?kind ?host)")))
        times["arm"].append(took(lambda: board.request("robot", "(get-status)")))
        time.sleep(0.01)
print(json.dumps(times))
