; Cubes that wear tags beside cubes that wear shapes. They are so large that the cells of the tags can be read from the
; row.
(cell tags
  (world
    (cube-size 64)
    (cube circle (at 450 -165))
    (cube box    (mark apriltag-36h11 17) (at 450 -55))
    (cube lid    (mark aruco-4x4-50 3) (at 450 55))
    (cube cross  (at 450 165)))
  (domain "../../domains/blocks.scm")
  (host "localhost" (agents robot vision planner coordinator person)))
