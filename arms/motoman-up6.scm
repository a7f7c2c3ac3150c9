; Motoman UP6: six axes, each on its own, commanded in pulses. Its forearm leaves the elbow 130 mm beside the line to
; the wrist. Lengths a, m, n, limits and signs: the thesis, tables B.1 to B.3, its pulses from its listing; the rest of
; the lengths from its successor HP6. The pulses of axes 1, 4 and 6 and the speeds are assumed.
(arm motoman-up6
  (articulated (height 450) (offset 150) (upper-arm 570) (forearm 640) (raise 130) (wrist 95) (tool 130))
  (axis turn     (limits -170 170) (speed 140) (pulses-per-turn 484000))
  (axis shoulder (limits -90 155)  (speed 160) (sense -1) (zero 90) (pulses-per-turn 484000))
  (axis elbow    (limits -170 190) (speed 170) (zero -90) (pulses-per-turn 484000))
  (axis roll     (limits -180 180) (speed 335) (pulses-per-turn 283600))
  (axis pitch    (limits -135 135) (speed 335) (pulses-per-turn 283600))
  (axis spin     (limits -360 360) (speed 500) (pulses-per-turn 283600))
  (home  0 -60 -60 0 -90 0)
  (ready 0 -35 -70 0 -55 0))
