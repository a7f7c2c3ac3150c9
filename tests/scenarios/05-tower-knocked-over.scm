; The tower stands when a hand knocks it over: it is built again.
(scenario "finished tower knocked over"
  (cell "../../examples/01-blocks/cell.scm")
  (goal (on circle triangle) (on triangle square))
  (when (and (on circle triangle) (on triangle square) (arm-empty))
    (hand knock circle))
  (expect reached)
  (expect-seen (event ? difference ? ?))
  (within 240))
