; The cubes are sorted, whatever there are: the round one lies in the wrong tray, the others in a pile. When one is
; sorted, a hand takes it out again.
(scenario "cubes are sorted by their marks, in spite of a hand"
  (cell "cell.scm")
  (goal (forall (?x OBJECT) (sorted ?x)))
  (when (and (sorted cross) (arm-empty))
    (hand place cross 450 -10))
  (expect reached)
  (within 300))
