; The example of kitting, as it is told: stages, and a part that is waited for.
(scenario "two kits are packed, although a part runs out"
  (cell "../../examples/08-kitting/cell.scm")
  (goal (then (and (in circle first) (in cross first))
              (and (in square second) (in triangle second)))
        (wait 60))
  (before-goal (hand remove cross))
  (when (goal-state ? running (missing cross))
    (wait 5)
    (hand add cross "cross" 360 -60))
  (expect reached)
  (expect-seen (goal-state ? running (stage 2)))
  (within 400))
