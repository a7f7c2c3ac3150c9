(use-modules (pizarra agent-words) (pizarra test-checks))

(define (refused? thunk)
  (catch #t (lambda () (thunk) #f) (lambda (key . values) #t)))

(check "what the board can hold stands for itself"
       (plain-datum '(a "b" 3 (4.5 ()))) '(a "b" 3 (4.5 ())))
(check "truth becomes a symbol, a fraction a real" (plain-datum (list #t #f 1/2)) '(true false 0.5))
(check "what is no datum is refused"
       (map (lambda (value) (refused? (lambda () (plain-datum value))))
            (list car (vector 1) (expt 2 70) (inf) (cons 1 2) #\a))
       '(#t #t #t #t #t #t))
(check "lists that never end are refused"
       (let ((ring (list 1)))
         (set-cdr! ring ring)
         (let ((nest (list 1)))
           (set-car! nest nest)
           (list (refused? (lambda () (plain-datum ring))) (refused? (lambda () (plain-datum nest))))))
       '(#t #t))
(check "text joins values" (text "a" 1 'b "c") "a1bc")
(check "a word that needs a run is refused outside" (refused? (lambda () (tell (a b)))) #t)

(finish-checks)
