; The vision agent dies and comes back: what it learned is remembered, and the work goes on.
(scenario "vision agent killed and restarted"
  (cell "../../examples/01-blocks/cell.scm")
  (goal (on circle triangle) (on triangle square))
  (when (servo 2 ? ? ? ?)
    (kill vision) (wait 4) (restart vision))
  (expect reached)
  (within 240))
