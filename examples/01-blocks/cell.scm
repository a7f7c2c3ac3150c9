; Four marked cubes in a row before a CRS-F3, seen by a stereo camera that faces the arm. The world has it 20 mm and 2
; degrees away from where the agents take it to be, as if a person had put it up with a rule: docs/cameras.md.
(cell blocks
  (world
    (camera (at 1315 -9 191) (pan 0.5) (tilt -0.7) (roll 1.8))
    (cube circle   (at 450 -165))
    (cube triangle (at 450 -55))
    (cube square   (at 450 55))
    (cube cross    (at 450 165))
    (noise (sensor 3) (blur 0.7) (gradient 0.12)))
  (arm crs-f3)
  (domain "../../domains/blocks.scm")
  (host "localhost" (agents robot vision planner coordinator person)))
