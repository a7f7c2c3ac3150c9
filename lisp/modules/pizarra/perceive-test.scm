(use-modules (pizarra test-checks) (pizarra perceive))

(define (section . parts) `(perception ,@parts))
(define low '(rule (low ?a) (seen ?a ? ? ?z) (< ?z 40)))

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
