; CRS-F3, built as the KUKA KR3: six axes, each on its own, on a track of 5 m beside the table.
; Lengths and speeds: the KR3's; limits and signs: the thesis, tables B.1 and B.3. The track's speed is assumed.
(arm crs-f3
  (articulated (height 350) (offset 100) (upper-arm 265) (forearm 270) (wrist 75) (tool 130))
  (axis turn     (limits -180 180)     (speed 240))
  (axis shoulder (limits -135 45)      (speed 210) (zero 90))
  (axis elbow    (limits -135 135)     (speed 240))
  (axis roll     (limits -180 180)     (speed 375))
  (axis pitch    (limits -135 135)     (speed 300))
  (axis spin     (limits -18432 18432) (speed 375))
  (axis track    (limits 0 5000)       (speed 800) (along y) (zero -2500))
  (home  0 20 -80 0 -120 0 2500)
  (ready 0 0 -90 0 -90 0 2500))
