; CRS-T265: five axes on a track of 1 m that runs towards the table. A linkage holds the forearm and the tool against
; the base: moving axis 2 turns neither, so nothing needs compensation, but the tool's axis can meet its stops while
; the others move. Links, limits and signs: the thesis, tables B.1 to B.3; height, wrist and speeds are assumed.
(arm crs-t265
  (articulated (height 300) (upper-arm 254) (forearm 254) (wrist 50) (tool 130))
  (axis turn     (limits -175 175) (speed 175))
  (axis shoulder (limits 0 110)    (speed 175))
  (axis elbow    (limits -125 0)   (speed 175) (from base) (zero 90))
  (axis pitch    (limits -180 180) (speed 300) (from base) (stops -110 110))
  (axis spin     (limits -180 180) (speed 350))
  (axis track    (limits 0 1000)   (speed 500) (along x) (zero -500))
  (home  0 100 -72 -90 0 500)
  (ready 0 60 -90 -90 0 500))
