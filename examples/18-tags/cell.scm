; Cubes that wear tags beside cubes that wear shapes, so large that a camera of 320x240 reads the tags' cells. The eyes
; know the box and the lid from the beginning: nobody clicks on them.
(cell tags
  (world
    (cube-size 64)
    (cube circle (at 450 -165))
    (cube box    (mark apriltag-36h11 17) (at 450 -55))
    (cube lid    (mark aruco-4x4-50 3) (at 450 55))
    (cube cross  (at 450 165)))
  (tagged (box apriltag-36h11 17 38.4) (lid aruco-4x4-50 3 38.4))
  (domain "../../domains/blocks.scm")
  (host "localhost" (agents robot vision planner coordinator person)))
