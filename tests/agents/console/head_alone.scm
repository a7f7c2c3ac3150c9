; The cell of examples/03-moving-head with nobody but the eyes and the unit that turns them.
(cell head-alone
  (world
    (camera (at 1330 0 200) (head ptu46-17.5))
    (cube circle   (at 450 -165))
    (cube triangle (at 450 -55))
    (cube square   (at 450 55))
    (cube cross    (at 450 165)))
  (arm crs-f3)
  (domain "../../../domains/blocks.scm")
  (host "localhost" (agents vision pan-tilt)))
