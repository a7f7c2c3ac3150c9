; A cube lies so near the arm that no extension of it comes there: it goes in a straight line, carried by its track.
(scenario "a cube nearer than the arm can be drawn in"
  (cell "../../examples/01-blocks/cell.scm")
  (goal (on circle square))
  (when (operation ? (PICK-UP circle) running)
    (hand place circle 158 -158))
  (expect reached)
  (within 120))
