; A hand does a step of the plan while the arm is about another: the step is skipped, not repeated.
(scenario "a helpful hand does a step"
  (cell "../../examples/01-blocks/cell.scm")
  (goal (on triangle square) (on circle triangle))
  (when (on triangle square)
    (hand stack circle triangle))
  (expect reached)
  (expect-not (operation ? (STACK circle triangle) ?))
  (within 150))
