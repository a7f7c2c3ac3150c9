; The operators are in trays.scm; this file names the trays. Kits are packed by an order: each tray is a kit, and a goal
; says what is to be in it. The stages of a goal are kits one after another: (then (and (in circle first) (in cross
; first)) (in square second)). With (wait 60) the cell waits for a part that has run out.
(domain kitting
  (extends "trays.scm")
  (objects (first TRAY) (first-1 SLOT) (first-2 SLOT) (second TRAY) (second-1 SLOT) (second-2 SLOT))
  (facts (part-of first-1 first) (part-of first-2 first) (part-of second-1 second) (part-of second-2 second))

  (perception
    (fact (part-of first-1 first))
    (fact (part-of first-2 first))
    (fact (part-of second-1 second))
    (fact (part-of second-2 second))
    (fact (spot first-1 450 -210))
    (fact (spot first-2 450 -120))
    (fact (spot second-1 450 210))
    (fact (spot second-2 450 120))))
