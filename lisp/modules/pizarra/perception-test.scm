(use-modules (pizarra test-checks) (pizarra perception))

(define predicates '((on 2) (on-table 1) (near 2) (low 1)))

(define (domain . parts) `((domain test (types OBJECT) (perception ,@parts))))
(define (section . parts) `(perception ,@parts))

;; The errors' symbols and paths.
(define (refused . parts)
  (let ((outcome (interpret (apply domain parts) predicates)))
    (if (eq? (car outcome) 'errors)
        (map (lambda (e) (list (car e) (caddr e))) (cdr outcome))
        outcome)))

(define low '(rule (low ?a) (seen ?a ? ? ?z) (< ?z 40)))

(check "a section is normalised"
       (interpret (domain '(sees BLOCK) '(constant cube 60) '(fact (spot p 1 2)) low) predicates)
       `(ok ((section ,(section '(sees BLOCK) '(constant cube 60) '(fact (spot p 1 2)) low))
             (sees BLOCK) (constants (cube 60)) (facts (spot p 1 2)))))
(check "no section" (interpret '((domain test)) predicates)
       '(errors (missing-section "a domain needs a section (perception ...)" (0) ())))
(check "no domain" (car (interpret '((cell x)) predicates)) 'errors)

(check "an unbound variable in the head" (refused '(rule (low ?b) (seen ?a ? ? ?)))
       '((unbound-variable (0 3 1 1 1))))
(check "an unbound variable in a comparison" (refused '(rule (low a) (< ?z 3)))
       '((unbound-variable (0 3 1 2 1))))
(check "a variable of a not is not bound after it" (refused '(rule (low ?z) (not (seen ?z ? ? ?))))
       '((unbound-variable (0 3 1 1 1))))
(check "a variable that was belongs to no condition before"
       (refused '(rule (low ?o) (was (near ?o ?)) (seen ?o ? ? ?)))
       '((unbound-variable (0 3 1 2 1 1))))
(check "was of what has a value, of anything, and of a value that only its not knows"
       (car (interpret (domain '(rule (low ?o) (seen ?o ? ? ?) (was (near ? ?o)) (not (seen ?p ? ? ?) (was (low ?p)))))
                       predicates))
       'ok)
(check "an unknown constant" (refused '(rule (low ?z) (seen ? ? ? ?z) (< ?z cube)))
       '((unknown-constant (0 3 1 3 2))))
(check "a wrong arity" (refused '(rule (on ?z) (seen ? ? ? ?z))) '((wrong-arity (0 3 1 1))))
(check "a condition that asks for what nothing finds" (refused '(rule (low ?a) (sene ?a ? ? ?)))
       '((unknown-fact (0 3 1 2 0))))
(check "the nearest name is told"
       (cadr (cadr (interpret (domain '(rule (low ?a) (sene ?a ? ? ?))) predicates)))
       "nothing that could be found is called sene; the nearest is seen")
(check "a condition with too few arguments" (refused '(rule (low ?a) (seen ?a ? ?))) '((wrong-arity (0 3 1 2))))
(check "a belief of before with too many" (refused '(rule (low ?a) (seen ?a ? ? ?) (was (low ?a ?a))))
       '((wrong-arity (0 3 1 3 1))))
(check "what is measured, facts of the section, predicates and what a rule finds for others may be asked for"
       (car (interpret (domain '(fact (spot p 1 2)) '(rule (tall ?a) (seen ?a ? ? ?z) (> ?z 90))
                               '(rule (low ?a) (seen ?a ? ? ?) (edge ?a ?) (gripper ?) (grip ? ? ?) (spot ? ? ?)
                                      (on-table ?a) (not (tall ?a)) (not (unseen ?a))))
                       predicates))
       'ok)
(check "all mistakes at once" (length (refused '(constant cube x) '(fact (spot ?p)) '(rule) '(what))) 4)
(check "odd data" (map car (refused 3 '() '("a") '(rule (low 1) 7) '(rule (low 1) (seen ?a (1))) '(rule (low 1) (< 1))))
       '(malformed malformed malformed malformed malformed malformed))

(finish-checks)
