; A tower of three cubes of 60, 50 and 40 mm on the first of three places: see domains/sizes.scm.
(cell sizes
  (world
    (cube square   (size 60) (at 450 -150))
    (cube triangle (size 50) (on square))
    (cube circle   (size 40) (on triangle)))
  (domain "../../domains/sizes.scm")
  (host "localhost" (agents robot vision planner coordinator person)))
