; Two arms: ./pizarra repl examples/06-master-and-slave/cell.scm, and at its prompt (follower (follow)). From then on the
; UP6 goes where the CRS-F3 goes, as in a mirror and 200 mm further out: try (robot (move-h right 100)) and
; (ask (arm-pose ?arm ?x ?y ?z ? ? ?)); (follower (rest)) ends it. The place alone is followed: each tool keeps its own
; direction. Each arm has a table of its own.
(cell master-and-slave
  (world)
  (arm crs-f3)
  (slave motoman-up6 (offset 200 0 0) (mirror))
  (domain "../../domains/blocks.scm")
  (host "localhost" (agents robot slave follower)))
