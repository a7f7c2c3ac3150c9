; What the gripper holds is taken out of it and laid down: it is fetched again.
(scenario "block stolen out of the gripper"
  (cell "../../examples/01-blocks/cell.scm")
  (goal (on circle triangle))
  (when (and (holding circle) (operation ? (STACK circle triangle) running))
    (hand steal circle))
  (expect reached)
  (expect-seen (event ? difference ? ?))
  (within 180))
