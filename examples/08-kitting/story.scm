; Two kits in a row. The cross runs out before the first kit has it, and comes back later: it is waited for.
(scenario "two kits are packed, although a part runs out"
  (cell "cell.scm")
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
