"""hostile_teller.py TREE BOARD: tells the largest facts that a board takes, and then 10,000 a second, until somebody
tells a stop: five hundred last ones say so."""

import sys
import time

sys.path.insert(0, sys.argv[1] + "/blackboard/python")
from pizarra import Board, tell  # noqa: E402

with Board(sys.argv[2], "hostile") as board:
    for n in range(4):
        board.tell(f'(bulk {n} "{"y" * 900_000}")')
    print("large facts are told", flush=True)
    # Whoever is to stop this clears what stands first.
    while board.ask("(stop ?who ?reason)"):
        board.wait(0.05)
    begun = time.monotonic()
    batch = 0
    while not board.ask("(stop ?who ?reason)"):
        board.transact(steps=[tell(f'(bulk {10 + n % 500} "{batch * 1000 + n} <script>hurt</script>")') for n in range(1000)])
        batch += 1
        board.wait(max(0.0, begun + batch * 0.1 - time.monotonic()))
    board.transact(steps=[tell(f'(bulk {10 + n} "the end <script>hurt</script>")') for n in range(500)])
    print(f"{batch * 1000} facts in {time.monotonic() - begun:.1f} s", flush=True)
