; Somebody takes apart what is to be kept, and it is built again.
(scenario "a kept goal is built again"
  (cell "../../examples/01-blocks/cell.scm")
  (goal (keep (on circle triangle)))
  (when (goal-state ? kept ?)
    (wait 20) (hand place circle 450 -170))
  (expect reached)
  (expect-seen (event ? difference ? ((on circle triangle)))
               (event ? plan "goal 1 fell: it is built again" ?))
  (expect-not (goal 2 ?))
  (within 240))
