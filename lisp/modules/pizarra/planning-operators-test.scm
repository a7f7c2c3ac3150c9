(use-modules (pizarra test-checks) (pizarra planning-operators))

(define (wrong . operators)
  (let ((outcome (interpret operators)))
    (if (eq? (car outcome) 'errors)
        (map (lambda (error) (list (car error) (caddr error))) (cdr outcome))
        outcome)))

(check "the thesis' way, and both ways to delete"
       (interpret '((operator PICK-UP (params (<ob1> OBJECT)) (preconds (clear <ob1>) (arm-empty))
                              (effects (holding <ob1>) (del (clear <ob1>)) (del arm-empty)))))
       '(ok (domain operators ((OBJECT object)) () ((clear *) (arm-empty) (holding *)) ()
                    ((PICK-UP ((?ob1 OBJECT)) ((clear ?ob1) (arm-empty)) () () ((holding ?ob1))
                              ((clear ?ob1) (arm-empty)) ()))
                    ())))

(check "an unknown parameter" (wrong '(operator A (params (<a> T)) (effects (p <b>)))) '((unknown-variable (0 3 1 1))))
(check "one in a deletion" (wrong '(operator A (effects (del p <b>)))) '((unknown-variable (0 2 1 2))))
(check "a changed arity" (wrong '(operator A (preconds (p a)) (effects (p a b)))) '((wrong-arity (0 3 1))))
(check "across operators" (wrong '(operator A (effects (p))) '(operator B (effects (p a)))) '((wrong-arity (1 2 1))))
(check "a question mark" (wrong '(operator A (params (<a> T)) (effects (p ?a)))) '((malformed (0 3 1 1))))
(check "a parameter without a type" (wrong '(operator A (params <a>) (effects (p)))) '((malformed (0 2 1))))
(check "a parameter twice" (wrong '(operator A (params (<a> T) (<a> T)) (effects (p)))) '((repeated (0 2 2))))
(check "a negation" (wrong '(operator A (preconds (not (p))) (effects (p)))) '((malformed (0 2 1))))
(check "an empty deletion" (wrong '(operator A (effects (del)))) '((malformed (0 2 1))))
(check "no effects" (wrong '(operator A)) '((malformed (0 2))))
(check "effects mistyped" (wrong '(operator A (efects (p)))) '((unknown-section (0 2))))
(check "an unknown part" (wrong '(operator A (precond (p)) (effects (p)))) '((unknown-section (0 2))))
(check "an operator twice" (wrong '(operator A (effects (p))) '(operator A (effects (p)))) '((repeated (1))))
(check "something else" (wrong '(operator A (effects (p))) '(operatr B (effects (p)))) '((malformed (1))))
(check "all errors are found"
       (map car (wrong '(operator A (params (a T)) (effects (p <b>))) '(operator) 3))
       '(malformed unknown-variable malformed malformed))

;; With facts, which alone know the objects.
(define (wrong-with facts . operators)
  (let ((outcome (interpret operators facts)))
    (if (eq? (car outcome) 'errors)
        (map (lambda (error) (list (car error) (caddr error))) (cdr outcome))
        (car outcome))))

(check "an object of the facts" (wrong-with '((types (a T))) '(operator A (effects (p a)))) 'ok)
(check "one in Graphplan's way" (wrong-with '((a T) (effects (p a))) '(operator A (effects (p a)))) 'ok)
(check "an object that no facts name" (wrong-with '((types (a T)) 3 (types) (types b)) '(operator A (effects (p b))))
       '((unknown-object (0 2 1 1))))
(check "a deletion that is none" (wrong '(operator A (effects (delete p a)))) '((malformed (0 2 1))))

(finish-checks)
