"""hostile_teller.py TREE BOARD: tells the largest facts that a board takes, and then 10,000 a second for five seconds."""

import sys
import time

sys.path.insert(0, sys.argv[1] + "/blackboard/python")
from pizarra import Board, tell  # noqa: E402

with Board(sys.argv[2], "hostile") as board:
    for n in range(4):
        board.tell(f'(bulk {n} "{"y" * 900_000}")')
    print("large facts are told", flush=True)
    begun = time.monotonic()
    for batch in range(50):
        board.transact(steps=[tell(f'(bulk {10 + n % 500} "{batch * 1000 + n} <script>hurt</script>")') for n in range(1000)])
        board.wait(max(0.0, begun + (batch + 1) * 0.1 - time.monotonic()))
    print(f"50000 facts in {time.monotonic() - begun:.1f} s", flush=True)
