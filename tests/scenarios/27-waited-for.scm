; A block of the goal is away. The goal says who is missing, waits, and goes on when the block is back.
(scenario "a goal waits for a missing block"
  (cell "../../examples/01-blocks/cell.scm")
  (before-goal (hand remove circle))
  (goal (on circle triangle) (wait 60))
  (when (goal-state ? running (missing circle))
    (wait 20) (hand add circle "circle" 450 -170))
  (expect reached)
  (expect-seen (goal-state 1 running (missing circle))
               (event ? missing "what was missing is seen: going on" ?))
  (expect-not (goal 2 ?))
  (within 180))
