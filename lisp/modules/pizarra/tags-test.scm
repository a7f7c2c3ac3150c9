(use-modules (pizarra cell-test-checks) (pizarra test-checks))

;; The tags of a cell file, or how many complaints it has and the first one.
(define (tags . sections)
  (apply cell-part 'tags sections))

(check "a cell that names no tags looks for none" (tags) '())
(check "a family goes with the side of its tags" (tags '(tags (apriltag-36h11 40))) '((apriltag-36h11 40)))
(check "there may be several families" (tags '(tags (aruco-4x4-50 22.5) (apriltag-36h11 40)))
       '((apriltag-36h11 40) (aruco-4x4-50 22.5)))
(check "no family at all is a mistake" (tags '(tags)) '(1 malformed (0 2)))
(check "a family that is not known is refused" (tags '(tags (apriltag-36h12 40))) '(1 unknown-section (0 2 1)))
(check "a family has tags of one size" (tags '(tags (apriltag-36h11 40) (apriltag-36h11 60))) '(1 repeated (0 2 2)))
(check "a side is needed" (tags '(tags (apriltag-36h11))) '(1 malformed (0 2 1)))
(check "a side is a length" (tags '(tags (apriltag-36h11 0))) '(1 out-of-range (0 2 1 1)))
(check "a side has one number" (tags '(tags (apriltag-36h11 40 60))) '(1 malformed (0 2 1)))
(check "looking for more families would take too long"
       (tags '(tags (apriltag-36h11 40) (apriltag-25h9 40) (apriltag-16h5 40) (aruco-4x4-50 40) (aruco-5x5-50 40)))
       '(1 too-many (0 2 5)))
(check "tags may be said once" (tags '(tags (apriltag-36h11 40)) '(tags (aruco-4x4-50 40))) '(1 repeated (0 3)))

;; The same of tagged objects.
(define (tagged . objects)
  (cell-part 'tagged `(tagged ,@objects)))

(check "objects may be known by their tags"
       (tagged '(lid apriltag-36h11 17 48) '(box aruco-4x4-50 3 22.5))
       '((lid apriltag-36h11 17 48) (box aruco-4x4-50 3 22.5)))
(check "a tagged object has a name, a family, a number and a side"
       (list (tagged) (tagged '(lid)) (tagged '(lid apriltag-36h11)) (tagged '(lid apriltag-36h11 17)) (tagged 17))
       '((1 malformed (0 2)) (1 malformed (0 2 1)) (1 malformed (0 2 1)) (1 malformed (0 2 1)) (1 malformed (0 2 1))))
(check "a tag that no family has is refused"
       (list (tagged '(lid apriltag-36h12 1 48)) (tagged '(lid apriltag-16h5 30 48)))
       '((1 unknown-name (0 2 1 1)) (1 out-of-range (0 2 1 2))))
(check "a tagged object's side is a length, and nothing follows it"
       (list (tagged '(lid apriltag-36h11 17 0)) (tagged '(lid apriltag-36h11 17 48 1)))
       '((1 out-of-range (0 2 1 3)) (1 malformed (0 2 1 4))))
(check "no two objects have one name or one tag"
       (list (tagged '(lid apriltag-36h11 17 48) '(Lid apriltag-36h11 18 48))
             (tagged '(lid apriltag-36h11 17 48) '(box apriltag-36h11 17 40)))
       '((1 repeated (0 2 2)) (1 repeated (0 2 2))))

(finish-checks)
