; Nothing is known of where the camera stands. The arm takes its mark over the image by pixel errors alone, until that is
; found out.
(scenario "where the camera stands is not known at all"
  (cell "cells/unknown-camera.scm")
  (goal (on circle triangle) (on triangle square))
  (expect reached)
  (expect-seen (camera-pose ? ? ? ? ? ? unknown ? ?)
               (servo 1 end-effector ? ? ?)
               (camera-pose ? ? ? ? ? ? measured ? ?))
  (within 240))
