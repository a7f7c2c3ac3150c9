(use-modules (pizarra checks) (pizarra pddl-problem))

(define domain
  '(domain d ((block thing) (thing object)) ((table thing)) ((on block thing) (clear block)) ((weight block)) () ()))

(define (problem . sections)
  (interpret (list (cons* 'define '(problem p) '(:domain d) sections)) domain))

(define (wrong . sections)
  (let ((outcome (apply problem sections)))
    (if (eq? (car outcome) 'errors)
        (map (lambda (error) (list (car error) (caddr error))) (cdr outcome))
        outcome)))

(define objects '(:objects a b - block))
(define goal '(:goal (on a b)))

(check "a whole problem"
       (problem objects '(:init (on a b) (not (clear b)) (= (weight a) 3) (= (weight b) 2.0))
                '(:goal (and (on b a) (not (on a b)))) '(:metric minimize (total-cost)))
       '(ok (problem ((a block) (b block)) ((on a b)) (((weight a) 3) ((weight b) 2)) ((on b a)) ((on a b)) cost)))
(check "an empty goal" (problem objects '(:init) '(:goal (and)))
       '(ok (problem ((a block) (b block)) () () () () none)))
(check "a constant may be named again" (problem '(:objects table - thing) '(:goal ()))
       '(ok (problem () () () () () none)))

(check "an unknown object" (wrong objects '(:init (clear c)) goal) '((unknown-object (0 4 1 1))))
(check "an unknown type" (wrong '(:objects a b - block c - blok) goal) '((unknown-type (0 3 7))))
(check "an unknown predicate" (wrong objects goal '(:init (clera a))) '((unknown-predicate (0 5 1 0))))
(check "an unknown function" (wrong objects goal '(:init (= (wight a) 1))) '((unknown-function (0 5 1 1 0))))
(check "a wrong type" (wrong objects '(:init (on table a)) goal) '((wrong-type (0 4 1 1))))
(check "a wrong arity" (wrong objects '(:init (on a)) goal) '((wrong-arity (0 4 1))))
(check "a value that is no cost" (wrong objects '(:init (= (weight a) 1.5)) goal) '((bad-number (0 4 1 2))))
(check "a variable" (wrong objects '(:init (clear ?x)) goal) '((not-ground (0 4 1 1))))
(check "an object twice" (wrong '(:objects a a b - block) goal) '((repeated (0 3 2))))
(check "another domain" (interpret '((define (problem p) (:domain e) (:goal ()))) domain)
       '(errors (wrong-domain "this problem is one of the domain e, and the domain file defines d" (0 2) ())))
(check "no goal" (wrong objects) '((malformed (0))))
(check "two goals" (wrong objects '(:goal (clear a) (clear b))) '((malformed (0 4))))
(check "equalities that hold are no goals" (problem objects '(:goal (and (= a a) (not (= a b)))))
       '(ok (problem ((a block) (b block)) () () () () none)))
(check "equalities that do not hold never will" (problem objects '(:goal (and (= a b) (clear a) (not (= b b)))))
       '(ok (problem ((a block) (b block)) ((= b b)) () ((clear a) (= a b)) ((= b b)) none)))
(check "an equality of an unknown object" (wrong objects '(:goal (= a c))) '((unknown-object (0 4 1 2))))
(check "an equality of three" (wrong objects '(:goal (not (= a b a)))) '((malformed (0 4 1 1))))
(check "a disjunction" (wrong objects '(:goal (or (clear a) (clear b)))) '((unsupported (0 4 1))))
(check "another metric" (wrong objects goal '(:metric minimize (weight a))) '((unsupported (0 5))))
(check "all errors are found"
       (map car (wrong '(:objects a - block b - blok) '(:init (clera a) (on a) (on a c)) '(:goal (clear d))))
       '(unknown-type unknown-predicate wrong-arity unknown-object unknown-object))

(finish-checks)
