; A cell with an agent of its own that is a Scheme file: ./pizarra up examples/10-conveyor/cell.scm, then in another
; terminal ./pizarra tell '(barrier door blocked)' stops the arm, and ./pizarra why '(stop ? ?)' says why.
; ./pizarra tell '(barrier door free)' and ./pizarra retract '(stop conveyor ?)' let it go on.
(cell conveyor-cell
  (world
    (cube circle (at 450 -80))
    (cube triangle (at 450 80)))
  (agent conveyor (scheme "conveyor.scm"))
  (domain "../../domains/blocks.scm"))
