; The block is pushed while the fingers are around it already: far off it is followed by turning the arm, near by moving
; along a straight line. The thesis' fine state chooses one or the other.
(scenario "fine alignment turns where it is far off and shifts where it is near"
  (cell "../../examples/01-blocks/cell.scm")
  (goal (on circle square))
  (when (and (operation 0 (PICK-UP circle) running) (servo 4 circle ? ? ?))
    (hand push circle 0 11))
  (expect reached)
  (expect-seen (and (servo 4 circle ? ? ?) (request ? robot (turn ? ?)))
               (and (servo 4 circle ? ? ?) (request ? robot (move-h ? ?))))
  (expect-not (goal 2 ?))
  (within 120))
