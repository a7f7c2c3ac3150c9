; Eight cubes are told apart by their marks: two are put on others.
(scenario "eight marks"
  (cell "cells/eight-marks.scm")
  (goal (on letter-t letter-z) (on hourglass letter-y))
  (expect reached)
  (expect-not (event ? difference ? ?))
  (within 180))
