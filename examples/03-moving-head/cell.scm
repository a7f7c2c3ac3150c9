; The four cubes, seen by a pair of cameras on a PTU-46-17.5: (look-at cross) turns it, and what is seen stays where it is.
(cell moving-head
  (world
    (camera (at 1330 0 200) (head ptu46-17.5))
    (cube circle   (at 450 -165))
    (cube triangle (at 450 -55))
    (cube square   (at 450 55))
    (cube cross    (at 450 165)))
  (arm crs-f3)
  (domain "../../domains/blocks.scm"))
