; The coordinator dies in the middle of its plan and goes on from its facts.
(scenario "coordinator killed in the middle of its plan"
  (cell "../../examples/01-blocks/cell.scm")
  (goal (on circle triangle) (on triangle square))
  (when (on triangle square)
    (kill coordinator) (wait 3) (restart coordinator))
  (expect reached)
  (within 240))
