; A gantry over the table, described in metres and radians.
(arm gantry
  (units m rad)
  (gantry (height 0.7) (tool 0.13))
  (axis ahead  (limits 0 0.6)    (speed 0.8) (zero 0.05))
  (axis across (limits -0.5 0.5) (speed 0.8))
  (axis lift   (limits 0 0.55)   (speed 0.5) (sense -1))
  (axis spin   (limits -6.3 6.3) (speed 4))
  (home  0 0 0 0)
  (ready 0.32 0 0.16 0))
