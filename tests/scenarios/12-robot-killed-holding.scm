; The robot agent dies while the gripper holds a block: the block is still held when it comes back.
(scenario "robot agent killed while holding"
  (cell "../../examples/01-blocks/cell.scm")
  (goal (on circle triangle) (on triangle square))
  (when (holding ?)
    (kill robot) (wait 4) (restart robot))
  (expect reached)
  (within 240))
