;; Checks for the tests of our modules: a test file is a row of checks and ends with (finish-checks).

(define-module (pizarra test-checks)
  #:export (check finish-checks))

(define failures 0)

(define-syntax-rule (check what expression expected)
  (compare what expression expected))

(define (compare what value expected)
  (unless (equal? value expected)
    (set! failures (+ failures 1))
    (format #t "FAILED ~a~%  expected ~s~%  got      ~s~%" what expected value)))

(define (finish-checks)
  (exit (if (zero? failures) 0 1)))
