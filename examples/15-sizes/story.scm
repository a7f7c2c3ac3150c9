; Hanoi with three cubes. Half-way a person puts the smallest one onto the largest: the rest of the plan serves no more,
; and never does a larger cube come onto a smaller one.
(scenario "a tower of three sizes is moved, in spite of a hand"
  (cell "cell.scm")
  (goal (at square place-3) (on triangle square) (on circle triangle))
  (when (and (at square place-3) (arm-empty))
    (hand stack circle square))
  (expect reached)
  (expect-seen (operation 7 ? ?))
  (expect-not (on square triangle) (on square circle) (on triangle circle))
  (within 400))
