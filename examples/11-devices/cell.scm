; A cell with a light barrier before it: the arm stops when something is in the beam, and when nobody watches it, and
; stands until a person takes the stop back. That is no safety function. The barrier and a turntable are small devices
; that come through the text door: docs/small-devices.md.
(cell devices-cell
  (world
    (cube circle (at 450 -80))
    (cube triangle (at 450 80)))
  (agent guard (scheme "guard.scm"))
  (domain "../../domains/blocks.scm"))
