;; What tests of the cell language ask.
;;
;; (complaint SECTION ...) answers (COUNT SYMBOL PATH) of a cell of these sections, the number of complaints and the
;;   first one, or (ok ...)
;; (cell-part INDEX SECTION ...) answers that part of its value, or the same of a cell that is refused

(define-module (pizarra cell-checks)
  #:use-module (pizarra cell)
  #:export (complaint cell-part))

(define (complaint . sections)
  (let ((outcome (interpret (list (cons* 'cell 'c sections)))))
    (if (eq? (car outcome) 'errors)
        (list (length (cdr outcome)) (car (cadr outcome)) (caddr (cadr outcome)))
        outcome)))

(define (cell-part index . sections)
  (let ((outcome (apply complaint sections)))
    (if (eq? (car outcome) 'ok) (list-ref (cadr outcome) index) outcome)))
