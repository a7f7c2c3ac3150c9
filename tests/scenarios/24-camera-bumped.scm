; Somebody knocks against the camera while the first block is carried: 30 mm and 3 degrees.
(scenario "the camera is bumped in the middle of a goal"
  (cell "../../examples/01-blocks/cell.scm")
  (goal (on circle triangle) (on triangle square))
  (when (operation ? (STACK triangle square) running)
    (wait 1) (camera bump -20 20 10 1.5 -2 1.5))
  (expect reached)
  (expect-seen (camera-pose ? ? ? ? ? ? doubtful ? ?) (camera-pose ? ? ? ? ? ? measured ? ?))
  (within 240))
