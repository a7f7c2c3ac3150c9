;; The procedures that the tests of the passage between C++ and Scheme call.

(define-module (pizarra echo)
  #:use-module (pizarra forms)
  #:export (echo raise odd interpret))

(define (echo datum) datum)

(define (raise words)
  (error words 'and 'more))

(define (odd kind)
  (case kind
    ((procedure) car)
    ((boolean) #t)
    ((improper) '(1 . 2))
    ((infinite) (list (inf)))
    ((big) (expt 2 70))
    ((fraction) 1/2)
    ((nul) (string #\a #\nul))
    ((spaced-symbol) (string->symbol "a b"))
    ((circular) (circular-list 1 2))
    ((deep) (let loop ((n 10000) (out '())) (if (= n 0) out (loop (- n 1) (list out)))))))

(define (circular-list . items)
  (set-cdr! (cdr items) items)
  items)

(define (interpret data extra)
  (interpreting data
    (lambda (file)
      (let ((inside (node-within (node-within file "in the test") "in b")))
        (complain! (node-ref (node-ref inside 1) 1) 'odd "second ~a" extra)
        (complain! (node-ref (node-ref file 0) 1) 'odd "first")))))
