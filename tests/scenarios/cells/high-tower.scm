; Seven small cubes, five of them in one tower.
(cell high-tower
  (world
    (cube-size 48)
    (row (x 450) (y -245 245))
    (cube square    (at 450 -180))
    (cube circle    (on square))
    (cube cross     (on circle))
    (cube triangle  (on cross))
    (cube arrow     (on triangle))
    (cube hourglass (at 450 0))
    (cube star      (at 450 120)))
  (domain "../../../domains/blocks.scm"))
