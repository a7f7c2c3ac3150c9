; One block cannot stand on two others.
(scenario "goal contradictory"
  (cell "../../examples/01-blocks/cell.scm")
  (goal (on circle triangle) (on circle square))
  (expect refused no-plan)
  (expect-seen (goal-state 1 refused (fail no-plan ? ((on circle triangle) (on circle square)))))
  (expect-not (operation ? ? ?))
  (within 90))
