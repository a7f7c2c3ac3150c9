; A cell that is spoken to: ./pizarra repl examples/04-plain-english/cell.scm, and at its prompt
; (speech (say "move left 5 centimetres")) or (speech (say "pick up the circle")).
(cell plain-english
  (world
    (cube circle   (at 450 -100))
    (cube square   (at 450 0))
    (cube triangle (at 450 100)))
  (domain "../../domains/blocks.scm")
  (host "localhost" (agents robot vision planner coordinator person speech)))
