(use-modules (pizarra cell-test-checks) (pizarra test-checks))

;; The plain things of a cell's world, or how many complaints it has and the first one.
(define (things . given)
  (cell-part 'things `(world (cube circle (at 450 0)) ,@given)))

(check "a world may have no things" (things) '())
(check "bricks have three edges, cylinders a diameter and a height"
       (things '(brick wall (size 30 120 80) (at 300 100) (yaw 30)) '(cylinder can (size 50 70) (at 300 -100)))
       '((wall brick 30 120 80 300 100 30) (can cylinder 50 50 70 300 -100 0)))
(check "a thing has a size and a place"
       (list (things '(brick wall (at 300 100))) (things '(cylinder can (size 50 70)))
             (things '(brick wall (size 30 120) (at 300 100))) (things '(cylinder can (size 50 50 70) (at 300 0))))
       '((1 malformed (0 2 2)) (1 malformed (0 2 2)) (1 malformed (0 2 2 2)) (1 malformed (0 2 2 2))))
(check "sizes and places have bounds"
       (list (things '(brick wall (size 5 120 80) (at 300 100))) (things '(cylinder can (size 50 151) (at 300 0)))
             (things '(cylinder can (size 50 70) (at 660 0))))
       '((1 out-of-range (0 2 2 2 1)) (1 out-of-range (0 2 2 2 2)) (1 out-of-range (0 2 2 3 1))))
(check "a cylinder looks the same however it is turned"
       (things '(cylinder can (size 50 70) (at 300 0) (yaw 3))) '(1 unknown-section (0 2 2 4)))
(check "names are used once, whatever bears them"
       (list (things '(cylinder Circle (size 50 70) (at 300 0)))
             (things '(brick can (size 30 30 30) (at 300 0)) '(cylinder can (size 50 70) (at 300 100))))
       '((1 repeated (0 2 2)) (1 repeated (0 2 3))))
(check "things stand beside cubes and each other, not in them"
       (list (things '(brick wall (size 30 120 80) (at 404 0)))
             (things '(brick wall (size 30 120 80) (at 406 0)))
             (things '(brick a (size 20 150 80) (at 300 0) (yaw 45)) '(cylinder can (size 50 70) (at 320 40))))
       '(((wall brick 30 120 80 404 0 0)) (1 overlap (0 2 2)) (1 overlap (0 2 3))))

(finish-checks)
