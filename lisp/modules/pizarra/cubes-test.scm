(use-modules (pizarra cell-test-checks) (pizarra test-checks))

(define (cubes-in . cubes)
  (cell-part 'cubes `(world ,@cubes)))

(check "the gripper opens as the cubes' size asks"
       (map (lambda (part) (cell-part part '(world (cube-size 50) (row (x 460) (y -150 150))))) '(cube-size openings row))
       '(50 (66 74 86) (460 -150 150)))
(check "openings are the file's where it says them"
       (cell-part 'openings '(world (openings 70 80 90)))
       '(70 80 90))
(check "a cube that no gripper takes is refused" (complaint '(world (cube-size 70))) '(1 out-of-range (0 2 1 1)))
(check "openings that a cube does not fit between are refused"
       (complaint '(world (openings 60 84 96))) '(1 out-of-range (0 2 1 1)))
(check "openings have an order" (complaint '(world (openings 96 84 76))) '(1 malformed (0 2 1)))
(check "a row has a beginning and an end" (complaint '(world (row (y 200 -200)))) '(1 malformed (0 2 1 1)))
(check "smaller cubes may stand closer"
       (list (complaint '(world (cube circle (at 450 0)) (cube cross (at 450 55))))
             (car (complaint '(world (cube-size 50) (cube circle (at 450 0)) (cube cross (at 450 55))))))
       '((1 overlap (0 2 2)) ok))
(check "cubes may have sizes of their own, none above the cell's"
       (list (cubes-in '(cube circle (size 40) (at 450 0)) '(cube square (size 50) (at 450 46)))
             (complaint '(world (cube-size 50) (cube circle (size 60) (at 450 0))))
             (complaint '(world (cube circle (size 40) (at 450 0)) (cube square (size 50) (at 450 44)))))
       '(((circle circle 450 0 0 "" 40) (square square 450 46 0 "" 50)) (1 out-of-range (0 2 2 2 1)) (1 overlap (0 2 2))))
(check "a mark is the cube's name where it is one" (cubes-in '(cube circle (at 450 0) (yaw 5)))
       '((circle circle 450 0 5 "" 60)))
(check "a stacked cube stands where the lower one does"
       (cubes-in '(cube circle (at 450 0)) '(cube lid (mark cross) (on circle)))
       '((circle circle 450 0 0 "" 60) (lid cross 450 0 0 circle 60)))
(check "a cube needs a place" (complaint '(world (cube circle))) '(1 malformed (0 2 1)))
(check "a cube cannot stand on a later one" (complaint '(world (cube circle (on cross)) (cube cross (at 450 0))))
       '(1 unknown-object (0 2 1 2)))
(check "two cubes cannot stand on one"
       (complaint '(world (cube circle (at 450 0)) (cube cross (on circle)) (cube square (on circle))))
       '(1 occupied (0 2 3 2)))
(check "two cubes cannot stand in one place"
       (complaint '(world (cube circle (at 450 0)) (cube cross (at 455 10)))) '(1 overlap (0 2 2)))
(check "names are told apart without case"
       (complaint '(world (cube circle (at 450 0)) (cube Circle (mark circle) (at 450 100)))) '(1 repeated (0 2 2)))
(check "an unknown mark is refused" (complaint '(world (cube a (mark moon) (at 450 0)))) '(1 unknown-name (0 2 1 2 1)))
(check "a mark may be a tag"
       (cubes-in '(cube lid (mark apriltag-36h11 17) (at 450 0)) '(cube box (mark aruco-4x4-50 3) (on lid)))
       '((lid apriltag-36h11-17 450 0 0 "" 60) (box aruco-4x4-50-3 450 0 0 lid 60)))
(check "a family has tags up to a number"
       (list (cubes-in '(cube lid (mark apriltag-16h5 29) (at 450 0)))
             (complaint '(world (cube lid (mark apriltag-16h5 30) (at 450 0))))
             (complaint '(world (cube lid (mark apriltag-16h5 -1) (at 450 0)))))
       '(((lid apriltag-16h5-29 450 0 0 "" 60)) (1 out-of-range (0 2 1 2 2)) (1 out-of-range (0 2 1 2 2))))
(check "a tag has one whole number"
       (list (complaint '(world (cube lid (mark apriltag-36h11) (at 450 0))))
             (complaint '(world (cube lid (mark apriltag-36h11 1.5) (at 450 0))))
             (complaint '(world (cube lid (mark apriltag-36h11 1 2) (at 450 0)))))
       '((1 malformed (0 2 1 2)) (1 malformed (0 2 1 2 2)) (1 malformed (0 2 1 2 3))))
(check "an unknown family is refused" (complaint '(world (cube a (mark apriltag-36h12 1) (at 450 0))))
       '(1 unknown-name (0 2 1 2 1)))
(check "faces may have marks of their own"
       (cubes-in '(cube lid (mark apriltag-36h11 1) (faces (top cross) (left apriltag-36h11 2)) (at 450 0)))
       '((lid apriltag-36h11-1 450 0 0 "" 60 (left apriltag-36h11-2) (top cross))))
(check "a face that no cube has is refused, and one that is said twice, and one without a mark"
       (list (complaint '(world (cube circle (faces (lid cross)) (at 450 0))))
             (complaint '(world (cube circle (faces (top cross) (top star)) (at 450 0))))
             (complaint '(world (cube circle (faces (top)) (at 450 0)))))
       '((1 unknown-section (0 2 1 2 1)) (1 repeated (0 2 1 2 2)) (1 malformed (0 2 1 2 1))))
(check "what cannot be reached is refused" (complaint '(world (cube circle (at 4500 0)))) '(1 out-of-range (0 2 1 2 1)))

(finish-checks)
