(use-modules (pizarra checks) (pizarra perception))

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
(check "an unknown constant" (refused '(rule (low ?z) (seen ? ? ? ?z) (< ?z cube)))
       '((unknown-constant (0 3 1 3 2))))
(check "a wrong arity" (refused '(rule (on ?z) (seen ? ? ? ?z))) '((wrong-arity (0 3 1 1))))
(check "all mistakes at once" (length (refused '(constant cube x) '(fact (spot ?p)) '(rule) '(what))) 4)
(check "odd data" (map car (refused 3 '() '("a") '(rule (low 1) 7) '(rule (low 1) (seen ?a (1))) '(rule (low 1) (< 1))))
       '(malformed malformed malformed malformed malformed malformed))

(define (found section measured believed)
  (let ((outcome (perceive section measured believed)))
    (if (eq? (car outcome) 'ok) (cadr outcome) outcome)))

(define seen '((seen a 0 0 30) (seen b 5 0 90) (seen c 100 0 30)))

(check "a rule finds every answer" (found (section low) seen '()) '((low a) (low c)))
(check "constants and arithmetic"
       (found (section '(constant cube 60)
                          '(rule (on ?a ?b) (seen ?a ?x ? ?z) (seen ?b ?u ? ?w) (/= ?a ?b)
                                 (< (abs (- (- ?z ?w) cube)) 5)
                                 (<= (max (abs (- ?x ?u)) (min 1 2)) (* 3 (+ 1 2)))))
                 seen '())
       '((on b a)))
(check "later rules see what earlier ones found"
       (found (section low '(rule (near ?a ?b) (low ?a) (low ?b) (/= ?a ?b)) '(rule (alone ?a) (seen ?a ? ? ?) (not (near ?a ?))))
                 seen '())
       '((low a) (low c) (near a c) (near c a) (alone b)))
(check "not with several conditions"
       (found (section '(rule (top ?a) (seen ?a ? ? ?z) (not (seen ? ? ? ?w) (> ?w ?z)))) seen '())
       '((top b)))
(check "was gives hysteresis"
       (let ((rules (section '(rule (low ?a) (seen ?a ? ? ?z) (< ?z (if (was (low ?a)) 95 40))))))
         (list (found rules seen '()) (found rules seen '((low b)))))
       '(((low a) (low c)) ((low a) (low b) (low c))))
(check "the section's facts hold"
       (found (section '(fact (spot p 100)) '(rule (at ?a ?p) (spot ?p ?x) (seen ?a ?x ? ?))) seen '())
       '((at c p)))
(check "whole and broken numbers are the same number"
       (found (section '(rule (here ?a) (seen ?a 0 ? ?))) '((seen a 0.0 1 1)) '())
       '((here a)))
(check "a comparison of what is no number does not hold"
       (found (section '(rule (low ?a) (seen ?a ? ? ?) (< ?a 3)) '(rule (odd ?a) (seen ?a ? ? ?) (< (+ ?a 1) 3))) seen '())
       '())
(check "nothing seen, nothing found but what needs nothing"
       (found (section low '(rule (arm-empty) (not (holding ?)))) '() '())
       '((arm-empty)))


;; A row of sixteen, as many as a cell has.
(define row (map (lambda (n) (list 'seen (string->symbol (string-append "cube-" (number->string n))) (* 60 n) 0 30))
                 (iota 16)))

(define (join patterns)
  (map (lambda (n) `(seen ,(string->symbol (string-append "?q" (number->string n))) ? ? ?)) (iota patterns)))

(check "a rule that joins without end is given up and named"
       (let ((outcome (perceive (section low `(rule (far) ,@(join 12) (< 1 0))) row '())))
         (list (car outcome) (cadr outcome) (cadddr outcome)))
       '(fail too-much-work (far)))
(check "conditions inside not, if and was count too"
       (map (lambda (condition) (cadr (perceive (section `(rule (far) ,condition)) row row)))
            `((not ,@(join 12) (< 1 0))
              (< (if (not ,@(join 12) (< 1 0)) 1 2) 3)))
       '(too-much-work too-much-work))
(check "a rule that finds far too much is given up"
       (let ((outcome (perceive (section `(rule (near ?q0 ?q1 ?q2 ?q3) ,@(join 4))) row '())))
         (list (car outcome) (cadr outcome) (car (cadddr outcome))))
       '(fail too-much-work near))
(check "every pair and every triple of sixteen is no trouble"
       (length (found (section `(rule (pair ?q0 ?q1) ,@(join 2)) `(rule (any) ,@(join 3) (< 1 0))) row '()))
       256)
(check "what was too much once does not spoil the next look"
       (begin (perceive (section `(rule (far) ,@(join 12) (< 1 0))) row '())
              (found (section low) seen '()))
       '((low a) (low c)))

(finish-checks)
