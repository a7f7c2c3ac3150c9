; The eyes and the planner die and stay away: the next in line stand in. A server of a wrong kind never serves.
(scenario "others stand in for agents that died"
  (cell "cells/two-of-each.scm")
  (goal (on circle triangle) (on triangle square))
  (when (servo 2 ? ? ? ?)
    (kill vision) (wait 3) (kill planner))
  (expect reached)
  (expect-seen (holder coordinator eyes vision-2 stands-in))
  (expect-seen (holder coordinator planner planner-2 stands-in))
  (within 120))
