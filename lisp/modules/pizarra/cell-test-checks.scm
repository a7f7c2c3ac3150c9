;; What tests of the cell language ask.
;;
;; (complaint SECTION ...) reads a cell of these sections. It answers (ok ...), or (COUNT SYMBOL PATH): how many
;;   complaints there are, and the first one.
;; (cell-part NAME SECTION ...) answers that part of the cell's value, or the complaint.

(define-module (pizarra cell-test-checks)
  #:use-module (pizarra cell)
  #:export (complaint cell-part))

(define (complaint . sections)
  (let ((outcome (interpret (list (cons* 'cell 'c sections)))))
    (if (eq? (car outcome) 'errors)
        (list (length (cdr outcome)) (car (cadr outcome)) (caddr (cadr outcome)))
        outcome)))

(define (cell-part name . sections)
  (let ((outcome (apply complaint sections)))
    (if (eq? (car outcome) 'ok) (cadr (assq name (cadr outcome))) outcome)))
