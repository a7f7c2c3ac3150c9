"""What fails says so by raising a Failure.

    try:
        board.tell("(seen circle)")
    except Failure as failure:
        print(failure.symbol, failure.sentence, failure.subject)     # undeclared-relation ...

Symbols of a board: undeclared-relation, wrong-shape, precondition-failed, unknown-lease, not-permitted, too-large and
others. Of this client: unreachable; unavailable where several boards have no quorum of their log; timeout; bad-datum
for what cannot be said to a board, as None, nan or bytes; bad-address, bad-name, unreadable-file and bad-key for what it
cannot begin with; closed for what is asked of it after close(). An agent's operation raises one to answer (fail SYMBOL
SENTENCE SUBJECT).
"""

from __future__ import annotations

from typing import Any


# No board was there to do it: who asks again may be answered.
AWAY = ("unreachable", "unavailable")


class Failure(Exception):
    symbol: str
    sentence: str
    subject: Any
    place: str  # where in a text that was read: its lines, with a caret below; "" of anything else

    def __init__(self, symbol: str, sentence: str, subject: Any = (), place: str = "") -> None:
        super().__init__(f"{symbol}: {sentence}\n{place}".rstrip())
        self.symbol, self.sentence, self.subject, self.place = str(symbol), str(sentence), subject, place


def failure_from(form: Any) -> Failure:
    """Of (fail SYMBOL SENTENCE SUBJECT [PLACE]), as a board or an agent says it."""
    return Failure(*form[1:5])
