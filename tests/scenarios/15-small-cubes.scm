; The cell's cubes are smaller than those that the domain was written for: a tower of three stands all the same.
(scenario "small cubes"
  (cell "cells/small-cubes.scm")
  (goal (on circle triangle) (on triangle square) (on-table cross))
  (expect reached)
  (expect-not (event ? difference ? ?))
  (within 120))
