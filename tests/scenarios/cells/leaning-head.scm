; Four cubes, seen by a camera on a pan-tilt unit that leans, and whose axes pass behind and below the camera.
(cell leaning-head
  (world
    (camera (at 1318 12 192) (pan 1.2) (tilt 1.2) (roll 1)
            (head ptu46-17.5
                  (pan-axis (at 7 0 -41) (along 0.03 1 -0.02))
                  (tilt-axis (at 0 54 -33) (along 1 -0.015 0.025))))
    (cube circle   (at 450 -165))
    (cube triangle (at 450 -55))
    (cube square   (at 450 55))
    (cube cross    (at 450 165)))
  (camera-pose (at 1330 0 200) (sure 20 2))
  (arm crs-f3)
  (domain "../../../domains/blocks.scm"))
