; A tower of seven is higher than the arm travels otherwise. The arm passes over it, and knocks nothing down.
(scenario "high tower"
  (cell "cells/high-tower.scm")
  (goal (on hourglass arrow) (on star hourglass))
  (expect reached)
  (expect-not (event ? difference ? ?))
  (within 120))
