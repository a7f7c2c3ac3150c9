"""story_teller.py TREE BOARD declare|tell: declares what it tells, and tells how it begins; tells a story with two goals,
a plan that was made anew, facts because of facts, of which one has gone, and an arm that moves."""

import sys

sys.path.insert(0, sys.argv[1] + "/blackboard/python")
from pizarra import Board, retract, tell  # noqa: E402

EVENT = "(relation event ((seq integer) (kind symbol) (sentence string) (detail datum)) (key seq) (durable))"
POSTS = [
    EVENT,
    "(relation look ((eyes symbol) (frame integer) (text string) (of list)) (key eyes frame))",
    "(relation place ((name symbol) (x number) (y number) (z number) (frame integer)) (key name))",
    "(relation believed ((fact list)) (key fact))",
    "(relation arm-pose ((robot symbol) (x number) (y number) (z number) (rx number) (ry number) (rz number)) (key robot))",
    "(relation never ((told symbol)) (key told))",
]
RELATIONS = POSTS[:-1] + [
    "(relation contract ((name symbol) (form datum)) (key name))",
    "(relation goal ((n integer) (facts list)) (key n) (durable))",
    "(relation goal-state ((n integer) (state symbol) (detail list)) (key n) (durable))",
]
BEFORE = "(PICK-UP triangle) (STACK triangle square) (PICK-UP circle) (STACK circle triangle)"
AFTER = "(UNSTACK cross triangle) (PUT-DOWN cross) (PICK-UP circle) (STACK circle triangle)"
STORY = [
    "goal 'goal 1' ()",
    f"plan 'plan' (plan 1 ({BEFORE}))",
    "operation 'operation 1' (PICK-UP triangle)",
    "operation 'operation 2' (STACK triangle square)",
    "difference 'somebody put the cross on the triangle' ((clear triangle))",
    f"plan 'new plan' (plan 1 ({AFTER}))",
]



def declare(board):
    for relation in RELATIONS:
        board.declare(relation)
    for fact in ("(arm-pose robot 400 0 99 180 0 0)", "(place cross 500 0 30 1)", '(event 0 goal "it begins" ())'):
        board.tell(fact)


def tell_all(board):
    def number_of(query):
        return board.ask(query)[0].facts[0].id

    def told(fact, *because):
        board.transact(steps=[tell(fact, because=because)])
        return number_of(fact)

    told(f"(contract teller (contract teller (posts {' '.join(POSTS)})))")
    for number, event in enumerate(STORY, 1):
        told(f"(event {number} {event})".replace("'", '"'))
    told("(goal 1 ((on circle triangle) (on triangle square)))")
    told("(goal-state 1 running ())")
    told("(goal 2 ((on circle trianglo)))")
    told('(goal-state 2 refused (fail unknown-object "there is no trianglo" trianglo))')
    seen = told('(look eyes 7 "TRACK" ())')
    gone = told('(look eyes 8 "TRACK" ())')
    place = told("(place circle 400 0 60 7)", seen, gone)
    told("(believed (on circle triangle))", place)
    board.transact(steps=[retract("(look eyes 8 ?text ?of)")])
    for z in range(30):
        told(f"(arm-pose robot 400 0 {100 + z} 180 {z} 0)")
    told("(place square 300 0 30 7)")
    board.transact(steps=[retract("(place square ?x ?y ?z ?frame)")])


with Board(sys.argv[2], "teller") as client:
    (declare if sys.argv[3] == "declare" else tell_all)(client)
    print("done", flush=True)
