; Cubes of 50 mm, closer together than larger ones could stand.
(cell small-cubes
  (world
    (cube-size 50)
    (cube circle   (at 450 -135))
    (cube triangle (at 450 -45))
    (cube square   (at 450 45))
    (cube cross    (at 450 135)))
  (domain "../../../domains/blocks.scm"))
