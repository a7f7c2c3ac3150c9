; Four marked cubes before photographs: shelves behind the table, and a table of wood. A second lamp throws hard shadows.
(cell scenery
  (world
    (background "wall.png")
    (table-picture "table.png")
    (lamp (at 1200 -600 1300) (part 0.3))
    (cube circle   (at 450 -165))
    (cube triangle (at 450 -55))
    (cube square   (at 450 55))
    (cube cross    (at 450 165)))
  (domain "../../domains/blocks.scm"))
