; The hand moves the block left, back and right while the gripper comes to it (the thesis' Fig. 6.38): each time the arm
; comes over where the block is then, and the plan stays.
(scenario "block moved left, back and right during the approach"
  (cell "../../examples/01-blocks/cell.scm")
  (goal (on circle square))
  (when (and (operation 0 (PICK-UP circle) running) (servo 3 circle ? ? ?))
    (hand push circle 0 -40))
  (when (and (operation 0 (PICK-UP circle) running) (servo 3 circle ? ? ?) (arm-pose ? ? ?y ? ? ? ?) (< ?y -190))
    (hand push circle -30 0))
  (when (and (operation 0 (PICK-UP circle) running) (servo 3 circle ? ? ?) (arm-pose ? ?x ? ? ? ? ?) (< ?x 435))
    (hand push circle 0 70))
  (when (and (operation 0 (PICK-UP circle) running) (servo 4 circle ? ? ?) (arm-pose ? ? ?y ? ? ? ?) (> ?y -145))
    (wait 0))
  (expect reached)
  (expect-seen (event ? servo "circle was moved during the approach: following it" ?))
  (expect-not (goal 2 ?))
  (within 150))
