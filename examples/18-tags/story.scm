; A tower of both kinds of cubes. A hand moves the tagged block that the arm reaches for, and later knocks the top off.
(scenario "a tower of shapes and tags, in spite of a hand"
  (cell "cell.scm")
  (goal (on circle lid) (on lid box) (on-table cross))
  (when (and (operation ? (PICK-UP lid) running) (servo 3 lid ? ? ?))
    (hand push lid -20 25))
  (when (and (on circle lid) (on lid box) (arm-empty))
    (wait 0.5)
    (hand knock circle))
  (expect reached)
  (expect-seen (event ? difference ? ?))
  (within 240))
