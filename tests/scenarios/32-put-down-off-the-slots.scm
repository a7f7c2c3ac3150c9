; A cube is taken out of a slot and put down on the table, where it is not taken to lie in a slot again.
(scenario "put down off the slots"
  (cell "../../examples/07-sorting/cell.scm")
  (goal (on-table circle) (arm-empty))
  (expect reached)
  (expect-not (operation ? ? failed))
  (within 120))
