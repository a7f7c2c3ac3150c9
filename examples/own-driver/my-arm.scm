; The arm of my_arm.cpp: two links that fold level, a quill that slides down, and the tool's own turn.
(arm my-arm
  (scara (height 650) (upper-arm 350) (forearm 300) (tool 130))
  (axis turn  (limits -150 150) (speed 400))
  (axis elbow (limits -145 145) (speed 500))
  (axis lift  (limits 0 500)    (speed 800) (sense -1))
  (axis spin  (limits -360 360) (speed 1000))
  (home  60 -120 0 60)
  (ready 60 -120 100 60))
