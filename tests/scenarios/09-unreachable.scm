; A ring of blocks, each on the next: no plan exists, and it is proved.
(scenario "goal unreachable"
  (cell "../../examples/01-blocks/cell.scm")
  (goal (on circle triangle) (on triangle square) (on square circle))
  (expect refused no-plan)
  (expect-not (operation ? ? ?))
  (within 90))
