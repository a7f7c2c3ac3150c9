"""Questions, and what a board answers to them.

    for answer in board.ask("(and (seen ?name ?x) (< ?x 200))"):
        print(answer.bindings["?name"], answer.facts[0].teller)
"""

from __future__ import annotations

from typing import Any, Dict, List, Sequence

from pizarra.datum import Symbol, match
from pizarra.failure import Failure
from pizarra.reader import read
from pizarra.writer import datum_of, write

_NO_PATTERNS = frozenset(map(Symbol, ("not", "<", "<=", ">", ">=", "=", "/=")))


class Fact:
    """Something told: its number, the revision and the board's time it was told at, by whom, and because of which facts."""

    __slots__ = ("id", "revision", "microseconds", "teller", "datum", "because")
    id: int
    revision: int
    microseconds: int
    teller: str
    datum: Any
    because: List[int]

    def __init__(self, form: Sequence[Any]) -> None:
        self.id, self.revision, self.microseconds, self.teller, self.datum, *self.because = form


class Answer:
    """One way to satisfy a query: variables' values by "?name", and the facts of its positive patterns."""

    __slots__ = ("facts", "bindings")
    facts: List[Fact]
    bindings: Dict[str, Any]

    def __init__(self, patterns: Sequence[Any], facts: List[Fact]) -> None:
        self.facts = facts
        self.bindings = {}
        for pattern, fact in zip(patterns, facts):
            match(pattern, fact.datum, self.bindings)


class Answers(List[Answer]):
    """The answers to a question, as things were at a revision."""

    revision: int = 0


class Recalled(Answers):
    """The answers as things stood `age` seconds ago or later. What is not settled may be undone."""

    age: float = 0.0
    settled: bool = True


class Change:
    """What became true and false at a revision; resynchronised: `added` is all that holds, what was known is void."""

    __slots__ = ("revision", "resynchronised", "added", "removed")

    def __init__(self, revision: int, resynchronised: bool, added: List[Answer], removed: List[Answer]) -> None:
        self.revision, self.resynchronised, self.added, self.removed = revision, resynchronised, added, removed


def query_of(given: Any) -> List[Any]:
    """A pattern, (and CLAUSE ...) or (query QUERY OPTION ...), as data or as text."""
    query = read(write(datum_of(given)))
    if not isinstance(query, list) or len(query) < 1 + (query[:1] == [Symbol("query")]):
        raise Failure("bad-query", "a query is a pattern, (and CLAUSE ...) or (query QUERY OPTION ...)", query)
    return query


def patterns_of(query: List[Any]) -> List[Any]:
    """The patterns whose facts an answer has; of a query that a board has understood."""
    query = query[1] if query[0] == Symbol("query") else query
    clauses = query[1:] if query[0] == Symbol("and") else [query]
    return [clause for clause in clauses if clause[0] not in _NO_PATTERNS]


def relations_of(query: List[Any]) -> List[str]:
    """What it is about, also where it says `not`."""
    query = query[1] if query[0] == Symbol("query") else query
    clauses = query[1:] if query[0] == Symbol("and") else [query]
    denied = [clause[1] for clause in clauses if clause[0] == Symbol("not")]
    return [str(pattern[0]) for pattern in patterns_of(query) + denied]


def answers_from(query: List[Any], forms: Sequence[Any]) -> List[Answer]:
    patterns = patterns_of(query)
    return [Answer(patterns, [Fact(fact) for fact in form]) for form in forms]
