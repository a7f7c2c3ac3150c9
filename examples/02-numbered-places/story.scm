; Two cubes change places by way of a third place.
(scenario "two cubes change places"
  (cell "cell.scm")
  (goal (at circle place-2) (at triangle place-1))
  (expect reached)
  (within 240))
