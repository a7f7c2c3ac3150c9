; Lenses that bend the images like barrels, and photographs behind the table and on it.
(cell bent-images
  (world
    (camera (lens -0.3 0.05 0.001 -0.001))
    (background "../../../examples/19-scenery/wall.png")
    (table-picture "../../../examples/19-scenery/table.png")
    (cube circle   (at 450 -165))
    (cube triangle (at 450 -55))
    (cube square   (at 450 55))
    (cube cross    (at 450 165)))
  (domain "../../../domains/blocks.scm"))
