; Nobody interferes: the shortest plan is carried out once, and nothing differs from what was expected.
(scenario "undisturbed"
  (cell "../../examples/01-blocks/cell.scm")
  (goal (on circle triangle) (on triangle square))
  (expect reached)
  (expect-not (event ? difference ? ?))
  (within 120))
