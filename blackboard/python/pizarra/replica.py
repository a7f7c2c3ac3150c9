"""A relation that a client of a board holds itself: what it is asked about it alone is answered without the board.

    board.replicate("(relation seen ((name string) (x number)) (key name))")
    board.ask('(seen "circle" ?x)')          # from here; as fast as a dictionary where the key is given

Patterns of that one relation, with `not` and comparisons, are answered from here; whatever else is asked goes to the
board. A client reads its own writes: a board says with every reply at which revision it is, and whether all changes up
to there have come here before. Where they have not, it is asked.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Dict, List, Optional

from pizarra.answers import Answers, Fact, relations_of
from pizarra.datum import Symbol, is_variable
from pizarra.evaluate import Conjunction
from pizarra.relation import Relation
from pizarra.watch_feed import Feed
from pizarra.writer import write

if TYPE_CHECKING:
    from pizarra.session import Session


class Replica(Feed):
    def __init__(self, session: "Session", relation: Relation) -> None:
        self.relation = relation
        self.whole = False
        self.revision = 0
        self._facts: Dict[int, Fact] = {}
        self._by_key: Dict[str, Fact] = {}
        super().__init__(session, relation.everything(), Symbol("held"))

    def begin_again(self) -> None:
        self.whole = False
        super().begin_again()

    def come(self, sequence: int, revision: int, kind: str, added: Any, removed: Any) -> None:
        if kind in ("yes", "first"):
            self.whole, self._facts, self._by_key = False, {}, {}
        for number in removed:
            gone = self._facts.pop(number, None)
            if gone:
                del self._by_key[self._key(gone.datum)]
        before: Optional[Fact] = None
        for form in added:
            before = _fact_after(before, form)
            self._facts[before.id] = before
            self._by_key[self._key(before.datum)] = before
        self.revision = revision
        self.whole = self.whole or kind in ("yes", "last")
        self.read_up_to(sequence, kind in ("first", "more"))

    def _key(self, datum: Any) -> str:
        return write([datum[place + 1] for place in self.relation.key])

    def look(self, pattern: List[Any]) -> List[Fact]:
        """Those that may fit, by their ids."""
        keys = [pattern[place + 1] for place in self.relation.key]
        if any(map(_has_variables, keys)):
            return [fact for _, fact in sorted(self._facts.items())]
        found = self._by_key.get(write(keys))
        return [found] if found else []


class Replicas:
    """Those of a session, and how far the board was when it answered last."""

    def __init__(self, session: "Session") -> None:
        self._session = session
        self._all: Dict[str, Replica] = {}
        self._done = self._caught_up = 0
        self._unsure = False
        session.on_revision = self._answered_at
        session.on_begun_again = self._begun_again

    def add(self, relation: Relation) -> Replica:
        replica = self._all.get(relation.name)
        if replica is None or replica.ended:
            replica = self._all[relation.name] = Replica(self._session, relation)
        return replica

    def remove(self, replica: Replica) -> None:
        self._all.pop(replica.relation.name, None)
        replica.close()

    def _begun_again(self) -> None:
        """What was known of the board's revisions is void."""
        self._done = self._caught_up = 0
        self._unsure = False

    def holds(self, query: List[Any]) -> bool:
        return self._concerned(query) is not None

    def _concerned(self, query: List[Any]) -> Optional[Replica]:
        """The one that the whole query is about."""
        try:
            names = set(relations_of(query))
        except (IndexError, TypeError):  # what is no query a board refuses in its own words
            return None
        return self._all.get(names.pop()) if len(names) == 1 else None

    def ask(self, query: List[Any]) -> Optional[Answers]:
        """Nothing where the board must be asked; so is it where it would refuse the question, in its own words."""
        replica = self._concerned(query)
        if replica is None or not replica.whole or self._unsure:
            return None
        conjunction = Conjunction.of(query, replica.relation)
        revision = max(replica.revision, self._caught_up)
        if conjunction is None or revision < self._done:
            return None
        answers = Answers(conjunction.answers(replica.look))
        answers.revision = revision
        return answers

    def _answered_at(self, revision: Optional[int], came: bool) -> None:
        if not self._all:
            return
        self._unsure = revision is None
        if revision is not None:
            self._done = max(self._done, revision)
            self._caught_up = max(self._caught_up, revision if came else 0)


def _fact_after(before: Optional[Fact], form: Any) -> Fact:
    """A fact told with the one before it, at the same time by the same teller, is (ID DATUM CAUSE ...)."""
    if before and isinstance(form[1], list):
        return Fact([form[0], before.revision, before.microseconds, before.teller, *form[1:]])
    return Fact(form)


def _has_variables(datum: Any) -> bool:
    return is_variable(datum) or isinstance(datum, list) and any(map(_has_variables, datum))


