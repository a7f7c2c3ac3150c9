; The person changes the mind in the middle of the plan.
(scenario "goal replaced in the middle of the plan"
  (cell "../../examples/01-blocks/cell.scm")
  (goal (on circle triangle) (on triangle square))
  (when (holding triangle)
    (goal (on cross square) (on circle cross)))
  (expect reached)
  (expect-seen (goal-state 1 replaced ?))
  (within 240))
