(use-modules (srfi srfi-1) (pizarra test-checks) (pizarra looks))

;; A camera that faces the arm, 1330 mm before it and 200 mm up.
(define camera '(431.0 159.5 119.5 90.0 (1330.0 0.0 200.0) (0.0 1.0 0.0) (0.0 0.0 -1.0) (-1.0 0.0 0.0)))
(define outline '(62 32 24))
(define low-grip '(480 0 30))

(define (near? a b) (every (lambda (x y) (< (abs (- x y)) 1e-6)) a b))

(check "what is straight ahead of the left camera stands half a base line left of the middle"
       (near? (place camera 159.5 119.5 (sqrt (+ (* 850 850) (* 45 45)))) '(480 -45 200)) #t)
(check "a range is no depth"
       (near? (place camera (+ 159.5 (* 431 (/ 245 850))) 119.5 (sqrt (+ (* 850 850) (* 200 200)))) '(480 200 200)) #t)

(check "the gripper hides what stands behind it and above its fingertips"
       (map (lambda (at) (hidden? camera outline low-grip at)) '((400 0 30) (400 40 150) (480 60 60)))
       '(#t #t #t))
(check "it hides nothing beside or before it"
       (map (lambda (at) (hidden? camera outline low-grip at)) '((400 150 30) (560 0 30)))
       '(#f #f))
(check "it hides nothing below it" (hidden? camera outline '(480 0 300) '(450 0 30)) #f)

;; ---- a whole look

(define comma (string->symbol ","))
(define (tracked . objects) (list (cons* 'TRACK (length objects) objects)))
(define (at x y d) (list x comma y comma d))

(define section
  '(perception
    (sees OBJECT)
    (rule (here ?a) (seen ?a ? ? ?) (not (unseen ?a)))
    (rule (gone ?a) (unseen ?a))
    (rule (stays ?a) (here ?a) (was (here ?a)))
    (rule (gripped) (gripper ?) (grip ? ? ?))))

(define (situation . remembered)
  (list camera '("hand" (0 0 -66) () 62 32 24) remembered '((gripper 60))))

(define (look data of situation)
  (interpret data of situation section '((here a))))

(check "a reply becomes places and predicates at once"
       (look (tracked (list "a" 'OK (at 159.5 119.5 850)) '("b" FAIL)) '() (situation))
       (list 'ok (list (list (cons "a" (place camera 159.5 119.5 850))) '() '(ok ((here a) (stays a))))))
(check "the face stands with its place, and what else is told of an object is let alone"
       (last (car (car (cadr (look (tracked (list "a" 'OK (at 159.5 119.5 850)))
                                   '(("a" seen 0.9 (left 159.5 119.5) (pose 1 2 3 4 5 6) (face -3.5))) (situation))))))
       -3.5)
(check "what is no face is none"
       (map (lambda (of)
              (length (car (car (cadr (look (tracked (list "a" 'OK (at 159.5 119.5 850))) of (situation)))))))
            '((("a" seen (face "x"))) (("a" (face 1 2))) (a 3 () ("b" (face 1))) (("a" face))))
       '(4 4 4 4))
(check "what was seen a moment ago is remembered, and unseen"
       (cdr (cadr (look (tracked '("a" FAIL)) '() (situation '("a" (450.0 200.0 30.0) 1 1)))))
       '(() (ok ((gone a)))))

;; The hand's mark, so high that the grip is low.
(define hand-low (list "hand" 'OK (at (+ 159.5 (* 431 (/ 45 850))) (+ 119.5 (* 431 (/ 104 850))) 856.3387)))

(check "what the gripper hides is not gone, but for so long"
       (map (lambda (excusable)
              (cdr (cadr (look (tracked hand-low '("a" FAIL)) '()
                               (situation (list "a" '(400.0 0.0 30.0) 1 excusable))))))
            '(1 0))
       '((("a") (ok ((here a) (stays a) (gripped)))) (() (ok ((gone a) (gripped))))))
(check "what the hand's mark shows is no object"
       (caddr (cadr (look (tracked hand-low) '() (situation)))) '(ok ((gripped))))
(check "where the mark is not seen the arm says where the grip is"
       (caddr (cadr (look (tracked '("hand" FAIL)) '()
                          (list camera '("hand" (0 0 -66) (480.0 0.0 30.0) 62 32 24) '() '((gripper 60))))))
       '(ok ((gripped))))

;; One image alone shows it.
(check "where the range of the hand's mark is rough the arm says how far away it is"
       (map (lambda (hand-grip spread)
              (let* ((all (list camera (list "hand" '(0 0 -66) hand-grip 62 32 24) '() '((gripper 60))))
                     (told (list (list "hand" 'seen (list 'range 800 spread))))
                     (looked (look (tracked (list "hand" 'OK (at 181.05 119.5 800))) told all)))
                (inexact->exact (round (cadr (caar (cadr looked)))))))
            '((430.0 0.0 134.0) (430.0 0.0 134.0) ())
            '(9.1 0.4 9.1))
       '(430 530 530))

(check "a reply that is none is an error in its place"
       (map car (cdr (look '((TRACK 2 ("a" FAIL))) '() (situation)))) '(wrong-count))
(check "another reply is none of a look" (car (look '((GET 0 ())) '() (situation))) 'errors)

(finish-checks)
