; The cubes before a camera whose place somebody measured with a rule. It stands 20 mm and 2 degrees elsewhere. The
; simulated world alone knows where: (world (camera ...)). The coordinator knows the guess: (camera-pose ...).
(cell guessed-camera
  (world
    (camera (at 1345 -10 191) (pan -1.2) (tilt 1.3) (roll -1))
    (cube circle   (at 450 -165))
    (cube triangle (at 450 -55))
    (cube square   (at 450 55))
    (cube cross    (at 450 165)))
  (camera-pose (at 1330 0 200) (sure 20 2))
  (domain "../../domains/blocks.scm"))
