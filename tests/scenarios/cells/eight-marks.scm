; Eight cubes with the marks that the examples do not use, in four piles on a wide row.
(cell eight-marks
  (world
    (row (x 450) (y -245 245))
    (cube arrow     (at 450 -195))
    (cube house     (at 450 -97))
    (cube star      (at 450 0))
    (cube letter-h  (at 450 97))
    (cube hourglass (on arrow))
    (cube letter-t  (on house))
    (cube letter-y  (on star))
    (cube letter-z  (on letter-h)))
  (domain "../../../domains/blocks.scm"))
