; Clients begin before their servers and outlive them (a). A server that died with its name bound comes back (b). All of
; several go and come (c). A server of a wrong kind is wired (d).
(scenario "servers come late, go and come back, and one of a wrong kind is wired"
  (cell "cells/two-of-each.scm")
  (before-goal (kill planner) (kill planner-2) (kill vision) (kill vision-2) (kill coordinator) (wait 3)
          (restart coordinator) (wait 1) (restart planner) (restart vision))
  (goal (on circle triangle) (on triangle square))
  (when (servo 2 ? ? ? ?)
    (kill vision) (kill planner) (kill robot) (wait 0.2) (restart robot) (restart planner) (restart vision))
  (when (operation 2 ? running)
    (wire coordinator eyes planner))
  (expect reached)
  (expect-seen (holder coordinator eyes vision stands-in))
  (within 240))
