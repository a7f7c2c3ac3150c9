"""Answers a question about facts that are here, as a board would: patterns are joined in the order they are written.

    conjunction = Conjunction.of(query, relation)     # nothing where only a board can answer it, or would refuse it
    for patterns, facts in conjunction.answers(look): ...

`look(PATTERN)` gives the facts that may fit a pattern, by their ids.
"""

from __future__ import annotations

import operator
from typing import Any, Callable, Dict, Iterable, Iterator, List, Optional, Set

from pizarra.answers import Answer, Fact
from pizarra.datum import Symbol, is_variable, match, same
from pizarra.relation import Relation

Bindings = Dict[str, Any]
Look = Callable[[List[Any]], Iterable[Fact]]

NOT = Symbol("not")
ANY = Symbol("?")
ORDERS: Dict[Symbol, Callable[[Any, Any], bool]] = {
    Symbol("<"): operator.lt, Symbol("<="): operator.le, Symbol(">"): operator.gt, Symbol(">="): operator.ge}
EQUALITIES = {Symbol("="): True, Symbol("/="): False}


class Conjunction:
    def __init__(self, clauses: List[List[Any]]) -> None:
        self._clauses = clauses
        self._patterns = [clause for clause in clauses if clause[0] != NOT and not _compares(clause)]

    @classmethod
    def of(cls, query: List[Any], relation: Relation) -> Optional["Conjunction"]:
        """Of a query that is about this relation alone. Options, as an order, are a board's affair."""
        clauses = query[1:] if query[0] == Symbol("and") else [query]
        bound: Set[str] = set()
        for clause in clauses:
            if not isinstance(clause, list) or not clause:
                return None
            pattern = clause[1] if clause[0] == NOT and len(clause) == 2 else clause
            if _compares(clause):
                if len(clause) != 3 or not _variables(clause) <= bound or not _have_order(clause):
                    return None
                continue
            if not isinstance(pattern, list) or pattern[:1] != [Symbol(relation.name)] or not relation.fits_pattern(pattern):
                return None
            if pattern is clause:
                bound |= _variables(pattern) - {str(ANY)}
        return cls(clauses) if clauses else None

    def answers(self, look: Look) -> List[Answer]:
        return [Answer(self._patterns, facts) for facts in self._extend(0, {}, [], look)]

    def _extend(self, step: int, bindings: Bindings, chosen: List[Fact], look: Look) -> Iterator[List[Fact]]:
        if step == len(self._clauses):
            yield chosen
            return
        clause = self._clauses[step]
        if _compares(clause):
            if _holds(clause, bindings):
                yield from self._extend(step + 1, bindings, chosen, look)
            return
        pattern = _substituted(clause[1] if clause[0] == NOT else clause, bindings)
        if clause[0] == NOT:
            if not any(match(pattern, fact.datum, {}) for fact in look(pattern)):
                yield from self._extend(step + 1, bindings, chosen, look)
            return
        for fact in look(pattern):
            both = dict(bindings)
            if match(pattern, fact.datum, both):
                yield from self._extend(step + 1, both, [*chosen, fact], look)


def _compares(clause: List[Any]) -> bool:
    return isinstance(clause[0], Symbol) and (clause[0] in ORDERS or clause[0] in EQUALITIES)


def _is_number(value: Any) -> bool:
    return isinstance(value, (int, float))


def _have_order(comparison: List[Any]) -> bool:
    return comparison[0] in EQUALITIES or all(is_variable(value) or _is_number(value) for value in comparison[1:])


def _holds(comparison: List[Any], bindings: Bindings) -> bool:
    name = comparison[0]
    a, b = _substituted(comparison[1:], bindings)
    numbers = _is_number(a) and _is_number(b)
    if name in EQUALITIES:
        return (bool(a == b) if numbers else same(a, b)) is EQUALITIES[name]
    return bool(numbers and ORDERS[name](a, b))


def _substituted(datum: Any, bindings: Bindings) -> Any:
    if is_variable(datum):
        return bindings.get(str(datum), datum)
    return [_substituted(item, bindings) for item in datum] if isinstance(datum, list) else datum


def _variables(datum: Any) -> Set[str]:
    if is_variable(datum):
        return {str(datum)}
    return set().union(*map(_variables, datum)) if isinstance(datum, list) else set()
