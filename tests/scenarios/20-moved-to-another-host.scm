; Agents move to another host while the arm works: their names go with them.
(scenario "agents move to another host"
  (cell "../../examples/01-blocks/cell.scm")
  (goal (on circle triangle) (on triangle square))
  (when (servo 2 ? ? ? ?)
    (kill vision) (restart vision "bench"))
  (when (operation 1 ? running)
    (kill planner) (restart planner "desk"))
  (expect reached)
  (expect-seen (and (agent vision vision "bench") (bound (cell eyes) vision vision vision)))
  (expect-seen (and (agent planner planner "desk") (bound (cell planners) planner planner planner)))
  (within 240))
