; Twelve marked cubes in seven piles, told apart by four shapes and eight tags: three are put on others.
(scenario "twelve objects"
  (cell "cells/twelve-objects.scm")
  (goal (on circle triangle) (on left cross) (on red black))
  (expect reached)
  (within 240))
