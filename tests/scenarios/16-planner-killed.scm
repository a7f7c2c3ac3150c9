; The planner dies in the middle of its plan and goes on from its facts.
(scenario "planner killed in the middle of its plan"
  (cell "../../examples/01-blocks/cell.scm")
  (goal (on circle triangle) (on triangle square))
  (when (on triangle square)
    (kill planner) (wait 3) (restart planner))
  (expect reached)
  (within 240))
