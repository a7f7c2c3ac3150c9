; A cell with an agent of its own that is a Scheme file: ./pizarra up examples/10-conveyor/cell.scm, then in another
; terminal ./pizarra tell '(barrier door blocked)' stops the arm, ./pizarra why '(stop ? ?)' says why, and
; ./pizarra tell '(barrier door free)' lets it go on.
(cell conveyor-cell
  (world
    (cube circle (at 450 -80))
    (cube triangle (at 450 80)))
  (agent conveyor (scheme "conveyor.scm"))
  (domain "../../domains/blocks.scm"))
