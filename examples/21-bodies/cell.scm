; A box with another tag on each of its sides, which the eyes know as one body, between two cubes with shapes.
(cell bodies
  (world
    (cube-size 64)
    (cube circle (at 450 -120))
    (cube box    (mark apriltag-36h11 17) (at 450 0)
                 (faces (right apriltag-36h11 18) (back apriltag-36h11 19) (left apriltag-36h11 20)))
    (cube cross  (at 450 120)))
  (tagged (box-front apriltag-36h11 17 38.4) (box-right apriltag-36h11 18 38.4)
          (box-back apriltag-36h11 19 38.4) (box-left apriltag-36h11 20 38.4))
  (bodies (box (box-front (0 0 -32) (0 0 0)) (box-right (32 0 0) (0 -90 0))
               (box-back (0 0 32) (0 180 0)) (box-left (-32 0 0) (0 90 0))))
  (domain "../../domains/blocks.scm")
  (host "localhost" (agents robot vision planner coordinator person)))
