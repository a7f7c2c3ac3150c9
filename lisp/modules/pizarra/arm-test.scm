(use-modules (pizarra arm) (pizarra test-checks))

(define crane
  '((gantry (height 700) (tool 130))
    (axis ahead (limits 0 600) (speed 800))
    (axis across (limits -500 500) (speed 800))
    (axis lift (limits 0 500) (speed 500) (sense -1))
    (axis spin (limits -360 360) (speed 200))
    (home 0 0 0 0)
    (ready 300 0 100 0)))

(define (arm . sections) (interpret (list (cons* 'arm 'crane sections))))

;; CRANE with the section NEW in place of the one at INDEX.
(define (crane-with index new)
  (apply arm (append (list-head crane index) (list new) (list-tail crane (+ index 1)))))

(define (first-error outcome)
  (if (eq? (car outcome) 'errors) (list (car (cadr outcome)) (caddr (cadr outcome))) outcome))

(check "what is left out is zero, counts upwards and from the link before" (apply arm crane)
       '(ok (crane gantry (700 0 0 0 0 0 130 0 0)
                   ((ahead 0 600 800 1 0 link () 0 y) (across -500 500 800 1 0 link () 0 y)
                    (lift 0 500 500 -1 0 link () 0 y) (spin -360 360 200 1 0 link () 0 y))
                   (0 0 0 0) (300 0 100 0))))
(check "inches are millimetres in the end"
       (list-ref (cadr (arm '(units in deg) '(gantry (height 10)) '(axis ahead (limits 0 20) (speed 2))
                            '(axis across (limits 0 20) (speed 2)) '(axis lift (limits 0 20) (speed 2))
                            '(axis spin (limits 0 20) (speed 2)) '(home 0 0 0 0) '(ready 10 0 0 10)))
                 5)
       '(254.0 0.0 0.0 10))
(check "a unit nobody knows is refused" (first-error (apply arm (cons '(units feet deg) crane)))
       '(unknown-name (0 2 1)))
(check "limits have an order" (first-error (crane-with 1 '(axis ahead (limits 600 0) (speed 800))))
       '(malformed (0 3 2)))
(check "an axis has a speed" (first-error (crane-with 1 '(axis ahead (limits 0 600)))) '(malformed (0 3)))
(check "a gantry has no elbow" (first-error (crane-with 1 '(axis elbow (limits 0 600) (speed 8))))
       '(malformed (0 3)))
(check "an axis stands once"
       (assq-ref (cdr (apply arm (append crane '((axis spin (limits 0 1) (speed 1)))))) 'repeated)
       '("there is an axis for spin already" (0 9) ("in arm crane")))
(check "a pose names every axis" (first-error (crane-with 5 '(home 0 0 0))) '(malformed (0 7)))
(check "a pose lies within the limits" (first-error (crane-with 6 '(ready 900 0 100 0))) '(out-of-range (0 8 1)))
(check "an arm has links" (first-error (arm '(home 0) '(ready 0))) '(malformed (0)))
(check "links that cannot be without are missed"
       (first-error (arm '(scara (height 5)) '(axis turn (limits 0 1) (speed 1)) '(axis elbow (limits 0 1) (speed 1))
                         '(axis lift (limits 0 1) (speed 1)) '(axis spin (limits 0 1) (speed 1))
                         '(home 0 0 0 0) '(ready 0 0 0 0)))
       '(malformed (0 2)))
(check "a pitch behind a roll is not counted from the base"
       (first-error (arm '(polar (height 5)) '(axis turn (limits 0 1) (speed 1)) '(axis shoulder (limits 0 1) (speed 1))
                         '(axis reach (limits 0 1) (speed 1)) '(axis roll (limits 0 1) (speed 1))
                         '(axis pitch (limits 0 1) (speed 1) (from base)) '(axis spin (limits 0 1) (speed 1))
                         '(home 0 0 0 0 0 0) '(ready 0 0 0 0 0 0)))
       '(malformed (0 7)))
(check "an arm has one build, and its other is the one error"
       (cdr (apply arm (append crane '((polar (height 5))))))
       '((repeated "an arm has one build, and this one is gantry already" (0 9) ("in arm crane"))))
(check "stops are of an axis that a linkage holds"
       (first-error (arm '(articulated (upper-arm 400) (forearm 400))
                         '(axis turn (limits 0 1) (speed 1)) '(axis shoulder (limits 0 1) (speed 1))
                         '(axis elbow (limits 0 1) (speed 1) (stops 0 1)) '(axis spin (limits 0 1) (speed 1))
                         '(home 0 0 0 0) '(ready 0 0 0 0)))
       '(malformed (0 5 4)))
(check "every error is told" (length (cdr (arm '(gantry (hight 7)) '(axis ahead (limits 1 0) (speed 0)))))
       5)

(check "links beside axis 1 ask for a wrist that stays in their plane"
       (first-error (arm '(articulated (upper-arm 400) (forearm 400) (side 130))
                         '(axis turn (limits 0 1) (speed 1)) '(axis shoulder (limits 0 1) (speed 1))
                         '(axis elbow (limits 0 1) (speed 1)) '(axis roll (limits 0 1) (speed 1))
                         '(axis pitch (limits 0 1) (speed 1)) '(axis spin (limits 0 1) (speed 1))
                         '(home 0 0 0 0 0 0) '(ready 0 0 0 0 0 0)))
       '(malformed (0 2)))

(finish-checks)
