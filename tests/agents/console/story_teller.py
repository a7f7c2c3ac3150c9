"""story_teller.py TREE BOARD declare|tell|work|serve|more|approach: declares what it tells, and tells how it begins; tells a story
with two goals, a plan that was made anew, facts because of facts, of which one has gone, and an arm that moves; tells
260 entries of work, of which the newest 200 stand, as a coordinator does; tells a plan of which a part was done by
somebody else; tells one entry more; tells an approach that is over, and a mark that was lost and seen again."""

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
    "(relation plan ((n integer) (operations list)) (key) (durable))",
    "(relation plan-needs ((n integer) (needs list)) (key) (durable))",
    "(relation operation ((index integer) (operation list) (state symbol)) (key) (durable))",
    "(relation servo ((state integer) (object symbol) (x number) (y number) (d number)) (key))",
    "(relation tracked ((eyes symbol) (name string) (state symbol) (frame integer) (confidence number)) (key eyes name))",
    "(relation learned ((eyes symbol) (name string) (num integer) (area number) (perimeter number) (features integer)"
    " (m0 number) (m1 number) (m2 number)) (key eyes name num) (durable))",
]
# As a coordinator's contract: its predicates are what it posts and reads of symbols.
PURSUES = (
    "(contract teller (offers (goal (fact list) ...)) (posts (relation on ((upper symbol) (lower symbol)) (key upper))"
    " (relation clear ((ob symbol)) (key ob)) (relation arm-empty () (key)) (relation told ((ob symbol)) (key ob)))"
    " (reads on clear arm-empty))"
)
KEPT = 200
BEFORE = "(PICK-UP triangle) (STACK triangle square) (PICK-UP circle) (STACK circle triangle)"
AFTER = "(UNSTACK cross triangle) (PUT-DOWN cross) (PICK-UP circle) (STACK circle triangle)"
NEEDS = (
    "((clear triangle) (arm-empty))",
    "((holding triangle) (clear square))",
    "((on triangle square) (arm-empty))",
    "((holding circle) (not (clear circle)))",
    "((on circle triangle) (on triangle square))",
)
STORY = [
    "goal 'goal 1' ()",
    f"plan 'plan' (plan 1 ({BEFORE}))",
    "operation 'operation 1: (PICK-UP triangle)' (PICK-UP triangle)",
    "operation 'operation 2: (STACK triangle square)' (STACK triangle square)",
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
    told("(goal 1 ((on circle triangle) (on triangle square)))")
    told(f"(plan-needs 1 ({' '.join(NEEDS)}))")
    told("(believed (holding triangle))")
    for number, event in enumerate(STORY, 1):
        told(f"(event {number} {event})".replace("'", '"'))
    board.retract("(believed (holding triangle))")
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


def tell_event(board, number, event):
    steps = [tell(f"(event {number} {event})")]
    if number >= KEPT:
        steps.append(retract(f"(event {number - KEPT} ?kind ?sentence ?detail)"))
    board.transact(steps=steps)


def work(board):
    events = [
        'operation "picks up" (PICK-UP circle)',
        'servo "circle was moved during the approach: following it" circle',
        'difference "(clear circle) does not hold" ((clear circle))',
        'plan "the plan in hand still serves, from operation 2 on" (plan 1 ((STACK circle triangle)))',
        'operation "(STACK circle triangle) failed: it slipped" (fail slipped "it slipped" circle)',
        'agent "vision has gone" vision',
    ]
    for number in range(1, 261):
        tell_event(board, number, events[number % len(events)])
    board.tell("(goal 1 ((on circle triangle)))")
    board.tell("(goal-state 1 reached ())")


def approach(board):
    for state in (1, 2, 3, 4):
        for error in (9, 4, 1):
            board.tell(f"(servo {state} circle {error} {error} {error})")
    board.transact(steps=[retract("(servo ?state ?object ?x ?y ?d)")])
    for state in ("seen", "bridged", "lost", "seen"):
        board.tell(f'(tracked eyes "circle" {state} 7 0.9)')


def more(board):
    tell_event(board, 261, 'result "goal 1 is reached" ()')
    tell_event(board, 262, 'missing "the cross is not seen" cross')


def serve(board):
    plan = ["(PICK-UP triangle)", "(STACK triangle square)", "(PICK-UP circle)", "(STACK circle triangle)"]
    board.tell(f"(contract teller {PURSUES})")
    for name in ("circle", "square", "triangle", "end-effector"):
        board.tell(f'(learned eyes "{name}" 1 100 40 4 1 1 1)')
    board.tell(f"(plan 1 ({' '.join(plan)}))")
    story = [
        f'plan "plan" (plan 1 ({" ".join(plan)}))',
        f'operation "first" {plan[0]}',
        f'difference "somebody else did {plan[1]}: it is skipped" ({plan[1]})',
        f'plan "the plan in hand still serves, from operation 3 on" (plan 1 ({" ".join(plan[2:])}))',
        f'operation "third" {plan[2]}',
    ]
    for number, event in enumerate(story, 1):
        tell_event(board, number, event)
    board.tell(f"(operation 2 {plan[2]} running)")


WORDS = {"declare": declare, "tell": tell_all, "work": work, "more": more, "serve": serve, "approach": approach}
with Board(sys.argv[2], "teller") as client:
    WORDS[sys.argv[3]](client)
    print("done", flush=True)
