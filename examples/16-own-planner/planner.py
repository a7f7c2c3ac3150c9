"""A planner of one's own in the planner's role: breadth first, of the fewest operations (docs/facts/planner.md).

    ./pizarra up examples/01-blocks/cell.scm                                  prints the board's address
    PYTHONPATH=blackboard/python python3 examples/16-own-planner/planner.py BOARD-ADDRESS
    ./pizarra tell '(wired coordinator planner breadth-first)'                the next plan comes from here

Replace search(). Goals are facts here: one with `or`, `not` or a quantifier is refused.
"""

from collections import deque
from itertools import product
from typing import NamedTuple

from pizarra import Agent, Failure, Symbol

FORMULAS = {"and", "or", "not", "forall", "exists", "at-least"}
MOST_STATES = 1_000_000

agent = Agent("breadth-first", kind="planner", context="planners")
plans = {}  # by number, the newest alone: the actions and the goals


class Action(NamedTuple):
    """An operator with its parameters bound. Facts are tuples of text."""
    name: tuple
    needs: set
    adds: set
    deletes: set


def ground(operators, types):
    """Every operator with every choice of objects: ((NAME KIND) ...) behind the word `types`."""
    objects = {}
    for name, kind in types[1:]:
        objects.setdefault(str(kind), []).append(str(name))
    for _, name, *parts in operators:
        part = {str(form[0]): form[1:] for form in parts}
        params = part.get("params", [])
        for values in product(*(objects.get(str(kind), []) for _, kind in params)):
            bound = dict(zip((str(param) for param, _ in params), values))

            def fact(form):
                return tuple(bound.get(str(word), str(word)) for word in form)

            effects = part.get("effects", [])
            yield Action((str(name), *values), {fact(form) for form in part.get("preconds", [])},
                         {fact(form) for form in effects if str(form[0]) != "del"},
                         {fact(form[1]) for form in effects if str(form[0]) == "del"})


def facts_of(section):
    return {tuple(map(str, fact)) for fact in section[1:]}


def search(actions, initials, goals):
    start = frozenset(initials)
    came = {start: None}
    waiting = deque([start])
    while waiting:
        state = waiting.popleft()
        if goals <= state:
            plan = []
            while came[state]:
                state, action = came[state]
                plan.append(action)
            return plan[::-1]
        if len(came) > MOST_STATES:
            raise Failure("gave-up", f"no plan was found in {MOST_STATES} states", [])
        for action in actions:
            after = (state - action.deletes) | action.adds
            if action.needs <= state and after not in came:
                came[after] = (state, action)
                waiting.append(after)
    raise Failure("no-plan", "no plan exists: every state was tried", forms(goals))


def plan_for(operators, types, initials, goals):
    wanted = facts_of(goals)
    for fact in wanted:
        if fact[0] in FORMULAS:
            raise Failure("bad-task", f"this planner plans for facts, not for {fact[0]}", goals)
    return search(list(ground(operators, types)), facts_of(initials), wanted), wanted


def forms(facts):
    return [[Symbol(word) for word in fact] for fact in sorted(facts)]


def steps(plan):
    return [forms([action.name]) for action in plan]


@agent.operation("(make-plan (number integer) (operators list) (types list) (initials list) (goals list))")
def make_plan(number, operators, types, initials, goals):
    plans.clear()
    plans[number] = plan_for(operators, types, initials, goals)
    return steps(plans[number][0])


@agent.operation("(try-plan (operators list) (types list) (initials list) (goals list))")
def try_plan(operators, types, initials, goals):
    return steps(plan_for(operators, types, initials, goals)[0])


@agent.operation("(next-operation (number integer) (facts list))")
def next_operation(number, facts):
    """The first operation of the furthest end of the plan that serves from these facts."""
    if number not in plans:
        raise Failure("not-ready", "there is no such plan", number)
    plan, goals = plans[number]
    holds = {tuple(map(str, fact)) for fact in facts}
    needs = [goals]  # before each action, for the rest to reach the goals
    for action in reversed(plan):
        needs.insert(0, (needs[0] - action.adds) | action.needs)
    for index in range(len(plan), -1, -1):
        if needs[index] <= holds:
            rest = [[Symbol(word) for word in action.name] for action in plan[index:]]
            return index, rest, forms(needs[index]), forms(needs[min(index + 1, len(plan))])
    raise Failure("off-plan", "no remaining part of the plan fits what holds now", number)


agent.main()
