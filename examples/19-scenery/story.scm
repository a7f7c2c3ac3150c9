; A tower is built before the shelves, although a hand knocks off what was put there.
(scenario "a tower before photographs, in spite of a hand"
  (cell "cell.scm")
  (goal (on circle triangle) (on triangle square))
  (when (and (on circle triangle) (on triangle square) (arm-empty))
    (wait 0.5)
    (hand knock circle))
  (expect reached)
  (expect-seen (event ? difference ? ?))
  (within 240))
