(use-modules (pizarra test-checks) (pizarra forms) (pizarra pddl))

(define vocabulary
  (make-vocabulary '((block thing) (toy thing) (thing object)) '((on block thing)) '() '((a block) (b toy) (c thing))))

(define (facts . data)
  (interpreting data
    (lambda (text) (map (lambda (node) (read-atom vocabulary node (ground-term vocabulary))) (node-items text)))))

(check "a subtype stands for its parents" (facts '(on a b) '(on a c)) '(ok ((on a b) (on a c))))
(check "a parent does not stand for its subtype" (car (cadr (facts '(on c a)))) 'wrong-type)
(check "siblings do not stand for each other" (car (cadr (facts '(on b a)))) 'wrong-type)
(check "typed lists"
       (interpreting '(a b - block c)
         (lambda (text) (read-declarations (node-items text) "a name" name-node?
                                           (lambda (node) (known-type vocabulary node)))))
       '(ok ((a block) (b block) (c object))))
(check "conjunctions nest"
       (interpreting '((and (p) (and (q) (and)) (r)))
         (lambda (text) (map node-datum (conjuncts (node-ref text 0)))))
       '(ok ((p) (q) (r))))
(check "literals are said once" (literals-of '((fact (p)) (not (p)) (fact (q)) (fact (p))) 'fact) '((p) (q)))

(finish-checks)
