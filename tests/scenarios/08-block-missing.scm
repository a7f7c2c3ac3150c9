; A block that was learned and is needed is not there any more.
(scenario "a goal block missing"
  (cell "../../examples/01-blocks/cell.scm")
  (before-goal (hand remove circle))
  (goal (on circle triangle))
  (expect refused missing-object)
  (expect-not (operation ? ? ?))
  (within 90))
