(use-modules (pizarra calibration) (pizarra test-checks))

(define lens '((focal 535.9 536) (centre 342.3 235.5) (distortion -0.26 -0.04 0 0 0.25)))

;; A whole file with some sections replaced.
(define (file . replaced)
  (list (cons 'calibration
              (map (lambda (section) (or (assq (car section) replaced) section))
                   `((size 640 480) (left ,@lens) (right ,@lens) (rotation 1 0 0 0 1 0 0 0 1) (translation -60 0.1 0.2)
                     (board 9 6 25) (errors 13 0.3 0.2) (deviations 0.5 0.8 0.07))))))

(define (complaint data)
  (let ((outcome (interpret data)))
    (if (eq? (car outcome) 'errors) (list (length (cdr outcome)) (car (cadr outcome)) (caddr (cadr outcome))) outcome)))

(check "a calibration is read" (interpret (file))
       '(ok ((640 480) (535.9 536 342.3 235.5 -0.26 -0.04 0 0 0.25) (535.9 536 342.3 235.5 -0.26 -0.04 0 0 0.25)
             (1 0 0 0 1 0 0 0 1) (-60 0.1 0.2) (9 6 25) (13 0.3 0.2) (0.5 0.8 0.07))))
(check "what is missing is told" (complaint '((calibration (size 640 480)))) '(6 malformed (0 2)))
(check "a rotation is one" (complaint (file '(rotation 1 0 0 0 1 0 0 1 0))) '(1 out-of-range (0 4)))
(check "two cameras stand beside each other" (complaint (file '(translation 0 0 60))) '(1 out-of-range (0 5)))
(check "left and right are not swapped" (complaint (file '(translation 60 0 0))) '(1 out-of-range (0 5)))
(check "nor stands one above the other" (complaint (file '(translation -20 60 0))) '(1 out-of-range (0 5)))
(define (with-lens focal centre distortion)
  (complaint (file `(right (focal ,@focal) (centre ,@centre) (distortion ,@distortion)))))
(check "a focal length is a lens's" (with-lens '(1 1) '(320 240) '(0 0 0 0 0)) '(1 out-of-range (0 3)))
(check "a long one too" (with-lens '(90000 90000) '(320 240) '(0 0 0 0 0)) '(1 out-of-range (0 3)))
(check "pixels are nearly square" (with-lens '(500 1100) '(320 240) '(0 0 0 0 0)) '(1 out-of-range (0 3)))
(check "a lens looks at its image" (with-lens '(500 500) '(320 -500) '(0 0 0 0 0)) '(1 out-of-range (0 3)))
(check "or at a part of it" (car (with-lens '(500 500) '(-200 700) '(0 0 0 0 0))) 'ok)
(check "a distortion is a lens's" (with-lens '(500 500) '(320 240) '(1000 0 0 0 0)) '(1 out-of-range (0 3)))
(check "an error is none below 0" (complaint (file '(errors 13 -0.3 0.2))) '(1 out-of-range (0 7 2)))
(check "a lens has a focal length" (complaint (file '(left (centre 1 2) (distortion 0 0 0 0 0)))) '(1 malformed (0 2 3)))

(define (single . sections)
  `((calibration (size 640 480) (lens ,@lens) (board 9 6 25) (errors 13 0.3) ,@sections)))
(check "one camera alone has a lens" (interpret (single))
       '(ok ((640 480) (535.9 536 342.3 235.5 -0.26 -0.04 0 0 0.25) () () () (9 6 25) (13 0.3 0) (0 0 0))))
(check "one camera alone stands nowhere" (complaint (single '(translation -60 0 0))) '(1 unknown-section (0 5)))
(check "a lens is whole" (complaint '((calibration (lens (focal 500 500))))) '(5 malformed (0 1 2)))

(finish-checks)
