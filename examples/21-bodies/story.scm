; A tower is built with a box that a hand turns meanwhile: its left side looks at the camera then, and later its back.
(scenario "a tower with a box that is turned"
  (cell "cell.scm")
  (goal (on box cross) (on circle box))
  (when (operation ? (PICK-UP box) running)
    (hand turn box 90))
  (when (and (on box cross) (operation ? (PICK-UP circle) running))
    (hand turn box 90))
  (expect reached)
  (expect-seen (event ? difference ? ?))
  (within 240))
