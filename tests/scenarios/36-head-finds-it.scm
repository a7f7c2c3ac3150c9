; A block of the goal was carried out of the image. The head turns until it shows, and the goal is built.
(scenario "a block beside the image is found by the head"
  (cell "../../examples/03-moving-head/cell.scm")
  (before-goal (hand place circle 450 -290))
  (goal (on circle triangle))
  (expect reached)
  (expect-seen (event ? missing "circle is not in view: the head turns to look for it" ?)
               (head ?pan ?tilt still)
               (operation ? (PICK-UP circle) done))
  (within 120))
