; Four cubes, seen by a camera whose pose somebody measured with a rule.
(cell guessed-camera
  (world
    (camera (at 1318 12 192) (pan 1.2) (tilt 1.2) (roll 1))
    (cube circle   (at 450 -165))
    (cube triangle (at 450 -55))
    (cube square   (at 450 55))
    (cube cross    (at 450 165)))
  (camera-pose (at 1330 0 200) (sure 20 2))
  (arm crs-f3)
  (domain "../../../domains/blocks.scm")
  (host "localhost" (agents robot vision planner coordinator person)))
