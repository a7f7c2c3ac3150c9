"""counter: counts how often a barrier was blocked, tells the count, and may be asked for it.

    python3 counter.py ipc:///tmp/b        on the board that listens there, until Ctrl-C
"""

from pizarra import Agent, Symbol

agent = Agent("counter",
              posts=["(relation passed ((count integer)) (key))"],
              reads=["(relation barrier ((name symbol) (state symbol)) (key name))"])
count = 0
blocked = set()  # the facts that say so now


@agent.operation("(count)")
def answer_count():
    return count


@agent.watches("(barrier ?name blocked)")
async def barriers(change):
    """First all that are blocked, then every change; all again, resynchronised, where some may be missing."""
    global count, blocked
    came = {answer.facts[0].id for answer in change.added}
    gone = {answer.facts[0].id for answer in change.removed}
    new = came - blocked
    blocked = came if change.resynchronised else (blocked | came) - gone
    count += len(new)
    await agent.tell([Symbol("passed"), count], because=new)


if __name__ == "__main__":
    agent.main()
