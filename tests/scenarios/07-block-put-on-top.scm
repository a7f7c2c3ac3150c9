; Something is put on the block that is needed: it has to be cleared first.
(scenario "a block put on top of the one needed"
  (cell "../../examples/01-blocks/cell.scm")
  (goal (on circle triangle) (on triangle square))
  (when (operation ? (PICK-UP triangle) running)
    (hand stack cross circle))
  (expect reached)
  (expect-seen (operation ? (UNSTACK cross circle) ?))
  (within 240))
