; The coordinator dies in the middle of its plan and goes on from its facts: with the same goal, and with what is left of
; the same plan.
(scenario "coordinator killed in the middle of its plan"
  (cell "../../examples/01-blocks/cell.scm")
  (goal (on circle triangle) (on triangle square))
  (when (on triangle square)
    (kill coordinator) (wait 3) (restart coordinator))
  (expect reached)
  (expect-seen
    (event ? agent "going on with goal 1 after a restart" ?)
    (event ? plan "the plan in hand still serves, from operation 3 on: (PICK-UP circle) (STACK circle triangle)" ?))
  (expect-not (goal 2 ?))
  (within 240))
