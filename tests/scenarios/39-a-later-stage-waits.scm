; The second stage waits for a block that was taken away, while a hand undoes the first. A stage is judged once: when it
; is over.
(scenario "a later stage waits for a missing block"
  (cell "../../examples/01-blocks/cell.scm")
  (goal (then (on triangle square) (on circle square)) (wait 60))
  (when (goal-state ? running (stage 2))
    (hand remove circle))
  (when (goal-state ? running (stage 2 (missing circle)))
    (hand place triangle 450 -55) (wait 5) (hand add circle "circle" 450 -170))
  (expect reached)
  (expect-seen (goal-state 1 running (stage 2 (missing circle))))
  (within 240))
