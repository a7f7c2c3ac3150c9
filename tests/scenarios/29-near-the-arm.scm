; A tower is built upon a cube that was knocked near the arm, which stands there only because its track helps. It is
; carried aside by that, and comes back for the next cube.
(scenario "building near the arm"
  (cell "../../examples/01-blocks/cell.scm")
  (goal (on square triangle) (on cross square))
  (when (operation ? (PICK-UP square) running)
    (hand place triangle 215 -60))
  (expect reached)
  (within 120))
