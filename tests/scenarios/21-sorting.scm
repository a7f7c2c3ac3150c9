; The example of sorting, as it is told: a goal over whatever there is.
(scenario "cubes are sorted by their marks, in spite of a hand"
  (cell "../../examples/07-sorting/cell.scm")
  (goal (forall (?x OBJECT) (sorted ?x)))
  (when (and (sorted cross) (arm-empty))
    (hand place cross 450 -10))
  (expect reached)
  (within 300))
