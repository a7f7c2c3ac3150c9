; The hand moves the block while the gripper comes down on it: the servo follows.
(scenario "block moved during the approach"
  (cell "../../examples/01-blocks/cell.scm")
  (goal (on circle triangle) (on triangle square))
  (when (and (operation ? (PICK-UP ?block) running) (servo 3 ?block ? ? ?))
    (hand push ?block -20 25))
  (expect reached)
  (within 150))
