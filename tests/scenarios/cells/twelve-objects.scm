; Twelve marked cubes before a pair that looks down at them: shapes, and tags so small that images of 320x240 would not
; show their cells. A brick and a cylinder lie among them.
(cell twelve-objects
  (world
    (camera (at 1420 0 520) (tilt -23) (size 640 480))
    (cube-size 50)
    (row (x 520) (y -200 200))
    (cube circle   (at 430 -190))
    (cube triangle (at 430 -65))
    (cube square   (at 430 65))
    (cube cross    (at 430 190))
    (cube green    (mark apriltag-36h11 1) (at 320 -130))
    (cube blue     (mark apriltag-25h9 2) (at 320 0))
    (cube white    (mark apriltag-16h5 3) (at 320 130))
    (cube black    (mark aruco-4x4-50 4) (on blue))
    (cube grey     (mark aruco-5x5-50 5) (on cross))
    (cube red      (mark apriltag-36h11 6) (on white))
    (cube left     (mark apriltag-36h11 7) (on circle))
    (cube right    (mark apriltag-36h11 8) (on green))
    (brick wall    (size 40 30 20) (at 540 -290))
    (cylinder can  (size 40 50) (at 540 290)))
  (tagged (green apriltag-36h11 1 30) (blue apriltag-25h9 2 30) (white apriltag-16h5 3 30) (black aruco-4x4-50 4 30)
          (grey aruco-5x5-50 5 30) (red apriltag-36h11 6 30) (left apriltag-36h11 7 30) (right apriltag-36h11 8 30))
  (domain "../../../domains/blocks.scm"))
