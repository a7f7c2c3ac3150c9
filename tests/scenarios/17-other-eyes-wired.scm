; Other eyes and another planner are wired while the arm works: the next look and the next plan come from there.
(scenario "other eyes and another planner are wired"
  (cell "cells/two-of-each.scm")
  (goal (on circle triangle) (on triangle square))
  (when (servo 2 ? ? ? ?)
    (wire coordinator eyes vision-2) (wait 3) (wire coordinator planner planner-2))
  (expect reached)
  (expect-seen (and (holder coordinator eyes vision-2 wired) (tracked vision-2 "circle" ? ? ?)))
  (expect-seen (holder coordinator planner planner-2 wired))
  (expect-not (holder coordinator ? ? absent))
  (within 120))
