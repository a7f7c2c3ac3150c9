; The cell of examples/01-blocks without the person who teaches: nothing is learned, and nobody moves the arm.
(cell unattended
  (world
    (camera (at 1330 0 200))
    (cube circle   (at 450 -165))
    (cube triangle (at 450 -55))
    (cube square   (at 450 55))
    (cube cross    (at 450 165))
    (noise (sensor 3) (blur 0.7) (gradient 0.12)))
  (arm crs-f3)
  (domain "../../../domains/blocks.scm")
  (host "localhost" (agents robot vision planner coordinator)))
