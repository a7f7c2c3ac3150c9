"""An agent's contract: what it offers, posts, reads, lets others configure and monitor, as one s-expression.

    contract = Contract("lamp", offers=["(colour)", "(blink (times integer))"],
                        posts=["(relation lamp ((colour symbol)) (key))"], reads=["arm"])
    contract.check([Symbol("blink"), "often"])       # Failure wrong-shape
    board.tell([Symbol("contract"), Symbol("lamp"), contract.form])

`...` behind the last argument of an operation repeats it: (goal (fact list) ...). What it reads may be given as a whole
relation; the contract then has its name, and the agent declares it.
"""

from __future__ import annotations

import difflib
from typing import Any, Iterable, List

from pizarra.datum import Symbol
from pizarra.failure import Failure
from pizarra.relation import Argument, Relation, argument_of
from pizarra.writer import datum_of, write

# What all agents share.
RUNTIME_RELATIONS = [
    "(relation agent ((name symbol) (kind symbol) (host string)) (key name))",
    "(relation contract ((name symbol) (form datum)) (key name))",
    "(relation request ((id symbol) (agent symbol) (operation datum)) (key id))",
    "(relation reply ((id symbol) (result datum)) (key id) (lease 60000))",
]


class Operation:
    """(NAME (ARGUMENT TYPE) ...), and `...` where the last argument may stand any number of times."""

    def __init__(self, given: Any) -> None:
        form = datum_of(given)
        if not isinstance(form, list) or not form or not isinstance(form[0], Symbol):
            raise Failure("bad-contract", f"an operation is (NAME (ARGUMENT TYPE) ...): not {write(form)[:60]}", form)
        self.form, self.name = form, str(form[0])
        arguments = form[1:]
        self.repeats = arguments[-1:] == [Symbol("...")]
        if self.repeats and len(arguments) < 2:
            raise Failure("bad-contract", "`...` repeats the argument before it", form)
        self.arguments: List[Argument] = [argument_of(argument) for argument in
                                          (arguments[:-1] if self.repeats else arguments)]

    def check(self, operation: List[Any]) -> None:
        expected, given = list(self.arguments), operation[1:]
        if self.repeats:
            last = expected.pop()
            expected += [last] * (len(given) - len(expected))
        if len(given) != len(expected):
            raise Failure("wrong-shape", f"{self.name} takes {len(expected)} arguments, and has {len(given)} here: "
                                         f"it is {write(self.form)}", operation)
        for argument, value in zip(expected, given):
            if not argument.fits(value):
                raise Failure("wrong-shape", f"argument {argument.name} of {self.name} is of type {argument.type}: not "
                                             f"{write(value)[:60]}", operation)


class Contract:
    def __init__(self, kind: str, offers: Iterable[Any] = (), posts: Iterable[Any] = (), reads: Iterable[Any] = (),
                 configures: Iterable[Any] = (), monitors: Iterable[Any] = (), takes: Iterable[Any] = ()) -> None:
        self.kind = kind
        self.offers = [offer if isinstance(offer, Operation) else Operation(offer) for offer in offers]
        self.posts = [Relation(relation) for relation in posts]
        read = [datum_of(relation) for relation in reads]
        self.declares = [Relation(relation) for relation in read if isinstance(relation, list)]
        reads = [Symbol(relation[1]) if isinstance(relation, list) else Symbol(relation) for relation in read]
        self.form = [Symbol("contract"), Symbol(kind),
                     [Symbol("offers"), *(offer.form for offer in self.offers)],
                     [Symbol("posts"), *(relation.form for relation in self.posts)],
                     [Symbol("reads"), *reads],
                     [Symbol("configures"), *map(datum_of, configures)],
                     [Symbol("monitors"), *map(datum_of, monitors)]]
        taken = list(map(datum_of, takes))
        if taken:
            self.form.append([Symbol("takes"), *taken])
        write(self.form)

    @property
    def relations(self) -> List[Any]:
        """What an agent declares: what all share, what it posts, and what it reads where that is said whole."""
        return [*map(datum_of, RUNTIME_RELATIONS), *(relation.form for relation in self.posts + self.declares)]

    def check(self, operation: Any) -> None:
        """Whether it is offered and its arguments fit. Failures: unknown-operation, with the nearest; wrong-shape."""
        name = operation[0] if isinstance(operation, list) and operation else None
        for offered in self.offers:
            if name == Symbol(offered.name):
                return offered.check(operation)
        nearest = difflib.get_close_matches(str(name), [offered.name for offered in self.offers], 1)
        hint = f"; did you mean {nearest[0]}?" if nearest else ""
        raise Failure("unknown-operation", f"{self.kind} does not offer {write(operation)[:200]}{hint}", operation)
