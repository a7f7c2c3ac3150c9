; Somebody pulls the held cube out of the gripper and lays it down elsewhere: it is fetched again.
(scenario "block stolen out of the gripper"
  (cell "../../examples/01-blocks/cell.scm")
  (goal (on circle triangle))
  (when (and (holding circle) (operation ? (STACK circle triangle) running))
    (wait 0.5) (hand steal circle)
    (hand add circle "circle" 440 -200))
  (expect reached)
  (expect-seen (event ? difference ? ?))
  (within 180))
