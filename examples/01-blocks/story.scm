; The story of `pizarra demo`: a tower is built although a hand moves the block that the arm reaches for, and later knocks
; over what was built.
(scenario "a tower of three, in spite of a hand"
  (cell "cell.scm")
  (goal (on circle triangle) (on triangle square))
  (when (and (operation ? (PICK-UP ?block) running) (servo 3 ?block ? ? ?))
    (hand push ?block -20 25))
  (when (and (on circle triangle) (on triangle square) (arm-empty))
    (wait 0.5)
    (hand knock circle))
  (expect reached)
  (within 240))
