(use-modules (pizarra test-checks) (pizarra forms) (pizarra operators))

;; Parameters and facts as they stand, parameters as variables.
(define (read-all . operators)
  (interpreting operators
    (lambda (text)
      (read-operators (node-items text) node-datum
                      (lambda (params)
                        (define term (argument-reader params (lambda (node type) (node-datum node)) (const #t)))
                        (lambda (node items) (cons (node-datum (car items)) (map (lambda (item) (term item '*)) (cdr items)))))
                      (lambda (node fact adds)
                        (when (member fact adds) (complain! node 'contradictory "both")))))))

(define (wrong . operators)
  (map (lambda (error) (list (car error) (caddr error))) (cdr (apply read-all operators))))

(check "all its parts"
       (read-all '(operator A (params (<x> T) (<y> U)) (preconds (p <x>) (q a)) (effects (r <y>) (del (p <x>)) (s))))
       '(ok ((A ((?x T) (?y U)) ((p ?x) (q a)) ((r ?y) (s)) ((p ?x))))))
(check "several facts in one deletion, and Graphplan's way"
       (read-all '(operator A (params (<x> T)) (effects (del (p <x>) (q)) (del r <x>))))
       '(ok ((A ((?x T)) () () ((p ?x) (q) (r ?x))))))
(check "deletions are checked against what is added, wherever that stands"
       (wrong '(operator A (effects (del (p)) (p)))) '((contradictory (0 2 1 1))))
(check "an unknown parameter" (wrong '(operator A (params (<x> T)) (effects (p <y>)))) '((unknown-variable (0 3 1 1))))
(check "a parameter twice" (wrong '(operator A (params (<x> T) (<x> U)) (effects (p)))) '((repeated (0 2 2))))
(check "an operator twice" (wrong '(operator A (effects (p))) '(operator A (effects (p)))) '((repeated (1))))
(check "no effects, an empty deletion, an unknown part"
       (wrong '(operator A) '(operator B (effects (del))) '(operator C (del (p)) (effects (p))))
       '((malformed (0 2)) (malformed (1 2 1)) (unknown-section (2 2))))

(finish-checks)
