; Kits are packed by an order: see domains/kitting.scm.
(cell kitting
  (world
    (cube circle   (at 450 0))
    (cube triangle (on circle))
    (cube square   (at 360 60))
    (cube cross    (at 360 -60)))
  (domain "../../domains/kitting.scm")
  (host "localhost" (agents robot vision planner coordinator person)))
