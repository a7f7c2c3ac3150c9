(use-modules (srfi srfi-1) (pizarra driver) (pizarra forms) (pizarra test-checks))

(define protocols '((tcp ("the host") (80 81)) (lines ("the first line" "the second") ())))

;; The value of these words, or how many complaints they have and the first one.
(define (driver . words)
  (let ((outcome (interpreting `((driver ,@words))
                               (lambda (root) (driver-of-section (first (node-items root)) protocols)))))
    (if (eq? (car outcome) 'ok)
        (cadr outcome)
        (list (length (cdr outcome)) (car (cadr outcome)) (caddr (cadr outcome))))))

(check "ports that are left out are the protocol's own" (driver 'tcp "a" 1) '(tcp ("a") (1 81)))
(check "a protocol may have places alone" (driver 'lines "a" "b") '(lines ("a" "b") ()))
(check "every place must be given" (driver 'lines "a") '(1 malformed (0)))
(check "a place is text" (driver 'tcp 7) '(1 malformed (0 2)))
(check "a port is a port" (driver 'tcp "a" 0) '(1 out-of-range (0 3)))
(check "more ports than there are are refused" (driver 'tcp "a" 1 2 3) '(1 malformed (0 5)))
(check "a protocol that is not known is refused" (driver 'tpc "a") '(1 unknown-name (0 1)))

(finish-checks)
