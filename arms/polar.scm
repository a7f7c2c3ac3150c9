; A spherical arm, as the Unimate and the Stanford arm were: it turns, tilts and slides its forearm out.
(arm polar
  (polar (height 450) (wrist 75) (tool 130))
  (axis turn     (limits -160 160) (speed 110))
  (axis shoulder (limits -60 60)   (speed 60))
  (axis reach    (limits 0 600)    (speed 500) (zero 250))
  (axis roll     (limits -180 180) (speed 200))
  (axis pitch    (limits -120 120) (speed 200))
  (axis spin     (limits -360 360) (speed 300))
  (home  0 30 0 0 -120 0)
  (ready 0 15 150 0 -105 0))
