; The eyes straighten images that the lenses have bent, so that the tower is built without a surprise.
(scenario "bent images"
  (cell "cells/bent-images.scm")
  (goal (on circle triangle) (on triangle square))
  (expect reached)
  (expect-not (event ? difference ? ?))
  (within 180))
