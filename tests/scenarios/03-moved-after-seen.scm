; The block lies elsewhere by the time the arm goes for it.
(scenario "block moved after it was seen"
  (cell "../../examples/01-blocks/cell.scm")
  (goal (on circle triangle))
  (when (operation ? (PICK-UP circle) running)
    (hand place circle 480 -200))
  (expect reached)
  (within 120))
