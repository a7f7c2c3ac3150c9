; Somebody takes a block of a kept goal away. The arm looks for it once, and rests until it is back.
(scenario "a kept goal waits at rest for a block that was taken away"
  (cell "../../examples/01-blocks/cell.scm")
  (goal (keep (on circle triangle)))
  (when (goal-state ? kept ?)
    (wait 5) (hand remove circle))
  (when (goal-state 1 running (missing circle))
    (wait 200) (hand add circle "circle" 380 150))
  (expect reached)
  (expect-seen (and (goal-state 1 running (missing circle)) (arm ? idle ?))
               (event ? missing "what was missing is seen: going on" ?))
  (expect-not (and (goal-state 1 running (missing circle)) (arm ? moving ?)))
  (within 400))
