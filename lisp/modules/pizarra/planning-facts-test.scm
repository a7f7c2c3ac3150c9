(use-modules (pizarra test-checks) (pizarra planning-facts))

(define operators '(domain operators ((OBJECT object)) () ((clear *) (on * *) (arm-empty)) () () ()))
(define declared '(domain d ((OBJECT object) (PLACE object)) ((here PLACE)) ((clear OBJECT) (at OBJECT PLACE)) () () ()))

(define (wrong domain open . sections)
  (let ((outcome (interpret sections domain open)))
    (if (eq? (car outcome) 'errors)
        (map (lambda (error) (list (car error) (caddr error))) (cdr outcome))
        outcome)))

(check "the thesis' way"
       (interpret '((types (a OBJECT) (b OBJECT)) (initials (on a b) (arm-empty)) (goals (on b a))) operators 'open)
       '(ok (problem ((a OBJECT) (b OBJECT)) ((on a b) (arm-empty)) () ((on b a)) () none)))
(check "Graphplan's way"
       (interpret '((a OBJECT) ("b" OBJECT) (preconds (clear a)) (effects (clear "b"))) operators 'open)
       '(ok (problem ((a OBJECT) ("b" OBJECT)) ((clear a)) () ((clear "b")) () none)))
(check "what no operator speaks of may hold from the beginning"
       (interpret '((types (a OBJECT)) (initials (red a)) (goals (red a))) operators 'open)
       '(ok (problem ((a OBJECT)) ((red a)) () ((red a)) () none)))
(check "a declared domain with objects of its own"
       (interpret '((types (a OBJECT)) (goals (at a here))) declared 'closed)
       '(ok (problem ((a OBJECT)) () () ((at a here)) () none)))

(define (wrong-facts . sections) (apply wrong operators 'open '(types (a OBJECT)) sections))

(check "a slip in an initial fact" (wrong-facts '(initials (clera a)) '(goals (clear a))) '((unknown-predicate (1 1 0))))
(check "a goal of a new predicate" (wrong-facts '(goals (wanted a))) '((unknown-predicate (1 1 0))))
(check "a negation" (wrong-facts '(initials (not (red a))) '(goals (clear a) (not (clear a))))
       '((malformed (1 1)) (malformed (2 2))))
(check "an unknown object" (wrong-facts '(goals (on a c))) '((unknown-object (1 1 2))))
(check "a wrong arity" (wrong-facts '(goals (on a))) '((wrong-arity (1 1))))
(check "a slip in a type" (wrong operators 'open '(types (a OBJCET)) '(goals (arm-empty))) '((unknown-type (0 1 1))))
(check "a type that is not declared" (wrong declared 'closed '(types (a TOY)) '(goals (clear a)))
       '((unknown-type (0 1 1))))
(check "a wrong type" (wrong declared 'closed '(types (a OBJECT)) '(goals (clear here))) '((wrong-type (1 1 1))))
(check "a parameter" (wrong-facts '(goals (clear <a>))) '((malformed (1 1 1))))
(check "an object twice" (wrong operators 'open '(types (a OBJECT) (a OBJECT)) '(goals (clear a))) '((repeated (0 2))))
(check "one of the domain's own objects may be named again"
       (interpret '((types (here PLACE) (a OBJECT)) (goals (at a here))) declared 'closed)
       '(ok (problem ((a OBJECT)) () () ((at a here)) () none)))
(check "one with another type" (wrong declared 'closed '(types (here OBJECT)) '(goals (clear here)))
       '((repeated (0 1)) (wrong-type (1 1 1))))
(check "no goals" (wrong-facts '(initials (clear a))) '((malformed (2))))
(check "a section without goals" (wrong-facts '(goals) '(initials (clear a))) '((malformed (1))))
(check "goals mistyped" (wrong-facts '(gaols (clear a))) '((unknown-section (1))))
(check "an unknown section" (wrong-facts '(goals (clear a)) '(initial (clear a))) '((unknown-section (2))))
(check "all errors are found"
       (map car (wrong-facts '(initials (clera a) (on a) (on a c)) '(goals (under a a) 3)))
       '(unknown-predicate wrong-arity unknown-object unknown-predicate malformed))

(finish-checks)
