(use-modules (pizarra cell-test-checks) (pizarra test-checks))

;; The bodies of a cell file with two tagged objects, or how many complaints it has and the first one.
(define (bodies . given)
  (cell-part 'bodies '(tagged (front apriltag-36h11 17 40) (top apriltag-36h11 18 40)) `(bodies ,@given)))

(check "a cell may have no bodies" (cell-part 'bodies) '())
(check "a body has tagged objects at places of it, turned"
       (bodies '(box (front (0 0 -30) (0 0 0)) (Top (0 -30 0.5) (-90 0 0))))
       '((box ("front" (0 0 -30) (0 0 0)) ("top" (0 -30 0.5) (-90 0 0)))))
(check "a mark that no object wears is refused" (bodies '(box (left (0 0 0) (0 0 0)))) '(1 unknown-object (0 3 1 1 0)))
(check "a mark is on one body, and once"
       (list (bodies '(box (front (0 0 0) (0 0 0))) '(crate (front (0 0 0) (0 0 0))))
             (bodies '(box (front (0 0 0) (0 0 0)) (Front (0 0 30) (0 180 0)))))
       '((1 repeated (0 3 2 1)) (1 repeated (0 3 1 2))))
(check "a body has a name of its own"
       (list (bodies '(front (top (0 0 0) (0 0 0))))
             (bodies '(box (front (0 0 0) (0 0 0))) '(Box (top (0 0 0) (0 0 0)))))
       '((1 repeated (0 3 1 0)) (1 repeated (0 3 2))))
(check "a body has marks, and a mark a place and a turn"
       (list (bodies) (bodies 17) (bodies '(box)) (bodies '(box front)) (bodies '(box (front)))
             (bodies '(box (front (0 0 0)))) (bodies '(box (front (0 0) (0 0 0)))) (bodies '(box (front (0 0 0) (0 0 x))))
             (bodies '(box (front (0 0 0) (0 0 0) 1))))
       '((1 malformed (0 3)) (1 malformed (0 3 1)) (1 malformed (0 3 1)) (1 malformed (0 3 1 1))
         (1 malformed (0 3 1 1)) (1 malformed (0 3 1 1)) (1 malformed (0 3 1 1 1)) (1 malformed (0 3 1 1 2))
         (1 malformed (0 3 1 1 3))))
(check "places and turns have bounds"
       (list (bodies '(box (front (0 0 2001) (0 0 0)))) (bodies '(box (front (0 0 0) (0 -361 0)))))
       '((1 out-of-range (0 3 1 1 1 2)) (1 out-of-range (0 3 1 1 2 1))))

(finish-checks)
