; Somebody holds a block of the goal in the air: no plan is possible from there, and it is waited for.
(scenario "held in the air"
  (cell "../../examples/01-blocks/cell.scm")
  (goal (on circle triangle) (on-table triangle))
  (when (goal-state ? running ?)
    (hand hold triangle 430 -20 250 8))
  (expect reached)
  (within 180))
