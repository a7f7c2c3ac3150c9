; Cubes are sorted by the shape of their marks into two trays: see domains/sorting.scm.
(cell sorting
  (world
    (cube circle (at 450 120))
    (cube square (at 450 0))
    (cube cross  (on square)))
  (domain "../../domains/sorting.scm")
  (host "localhost" (agents robot vision planner coordinator person)))
