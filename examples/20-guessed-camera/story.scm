; The arm carries its mark before the camera until its pose is measured, and builds. A hand moves the block that the arm
; reaches for.
(scenario "a tower seen by a camera that was measured with a rule"
  (cell "cell.scm")
  (goal (on circle triangle) (on triangle square))
  (when (and (operation ? (PICK-UP ?block) running) (servo 3 ?block ? ? ?))
    (hand push ?block -20 25))
  (expect reached)
  (expect-seen (camera-pose ? ? ? ? ? ? measured ? ?))
  (within 240))
