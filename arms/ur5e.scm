; Universal Robots UR5e, driven as an arm of five axes: wrist 2 stands at -90 degrees, so that the tool stays in the
; plane of the links, which lies 133.3 mm to the left of the base's axis; axis 5 is wrist 3. Lengths: the maker's
; Denavit-Hartenberg parameters; limits and speeds: its data sheet, the limits of axes 2 to 4 drawn in so that the arm
; stays above the table. Joint angles are the controller's own; the base is turned so that the arm reaches ahead.
(arm ur5e
  (articulated (height 162.5) (side 133.3) (upper-arm 425) (forearm 392.2) (wrist 99.6) (across 99.7) (tool 130))
  (axis turn     (limits -355 -5)   (speed 180) (zero 180))
  (axis shoulder (limits -170 -10)  (speed 180) (sense -1))
  (axis elbow    (limits 5 160)     (speed 180) (sense -1))
  (axis pitch    (limits -200 60)   (speed 180) (sense -1) (zero -180))
  (axis spin     (limits -360 360)  (speed 180) (sense -1))
  (home  -180 -110 110 -90 0)
  (ready -180 -100 120 -110 0))
