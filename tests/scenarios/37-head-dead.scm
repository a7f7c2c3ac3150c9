; The pan-tilt agent is gone, and with it the knowledge of where the cameras look. The refusal says whose fault it is.
(scenario "the head's agent stays away"
  (cell "../../examples/03-moving-head/cell.scm")
  (before-goal (kill pan-tilt))
  (goal (on circle triangle))
  (expect refused absent)
  (expect-seen (event ? agent "nobody knows where the head looks: waiting until it stands" pan-tilt)
               (goal-state 1 refused (fail absent "nobody knows where the head looks any more" pan-tilt)))
  (expect-not (operation ? ? done))
  (within 90))
