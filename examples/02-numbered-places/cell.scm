; The same cubes on a table that has only numbered places: see domains/numbered-places.scm.
(cell numbered-places
  (world
    (cube circle   (at 450 -200))
    (cube triangle (at 450 -100))
    (cube square   (at 450 0)))
  (domain "../../domains/numbered-places.scm")
  (host "localhost" (agents robot vision planner coordinator person)))
