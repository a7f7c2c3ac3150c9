; Four cubes, seen by a camera that somebody has put aslant beside the row. Nobody has measured where it stands.
(cell unknown-camera
  (world
    (camera (at 1300 80 220) (pan -4) (tilt 0) (roll 2))
    (cube circle   (at 450 -165))
    (cube triangle (at 450 -55))
    (cube square   (at 450 55))
    (cube cross    (at 450 165)))
  (camera-pose unknown)
  (arm crs-f3)
  (domain "../../../domains/blocks.scm")
  (host "localhost" (agents robot vision planner coordinator person)))
