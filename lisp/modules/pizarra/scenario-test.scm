(use-modules (pizarra scenario) (pizarra test-checks))

(define (story . parts)
  (interpret (list `(scenario "s" (cell "c.scm") (goal (on a b)) ,@parts)) 50))

(define (complaint . parts)
  (let ((outcome (apply story parts)))
    (if (eq? (car outcome) 'errors) (list (length (cdr outcome)) (car (cadr outcome)) (caddr (cadr outcome))) outcome)))

(check "what is left out has a default" (story)
       '(ok ("s" "c.scm" "" () ((on a b)) () () reached "" () () 180 1)))
(check "events keep their order and variables"
       (list-ref (cadr (story '(when (holding ?x) (hand steal ?x)) '(when (on a b) (wait 1) (kill vision)))) 6)
       '(((holding ?x) (hand steal ?x)) ((on a b) (wait 1) (kill vision))))
(check "a refusal may be named" (list-ref (cadr (story '(expect refused missing-object))) 8) "missing-object")
(check "patterns of several sections are joined"
       (list-ref (cadr (story '(expect-not (a) (b)) '(expect-not (c)))) 10) '((a) (b) (c)))
(check "cubes are those of a cell" (list-ref (cadr (story '(cubes (cube circle (at 450 0))))) 3)
       '(cubes (circle circle 450 0 0 "" 50)))
(check "cubes need the room that those of the cell need"
       (complaint '(cubes (cube circle (at 450 0)) (cube square (at 450 49)))) '(1 overlap (0 4 2)))
(check "cubes may touch"
       (car (story '(cubes (cube circle (at 450 0)) (cube square (at 450 50))))) 'ok)
(check "an unknown operation of the hand is refused" (complaint '(when (a) (hand pull circle)))
       '(1 unknown-action (0 4 2)))
(check "an operation's arguments are counted" (complaint '(when (a) (hand push circle 4))) '(1 malformed (0 4 2)))
(check "fingers may be clumsy" (car (story '(before-goal (fingers slips 0.15 2 6.5) (fingers misplace 0.5)))) 'ok)
(check "a chance is at most 1" (complaint '(before-goal (fingers slips 1.5 2 6))) '(1 malformed (0 4 1)))
(check "fingers do not push" (complaint '(before-goal (fingers push))) '(1 unknown-action (0 4 1)))
(check "a camera may be bumped" (car (story '(when (a) (camera bump 10 -20 5 1 -2 0.5)))) 'ok)
(check "a head may be nudged" (car (story '(when (a) (head nudge 2 -1)))) 'ok)
(check "a nudge has two numbers" (complaint '(when (a) (head nudge 2))) '(1 malformed (0 4 2)))
(check "a bump has six numbers" (complaint '(when (a) (camera bump 10 -20))) '(1 malformed (0 4 2)))
(check "a camera does not walk" (complaint '(when (a) (camera walk))) '(1 unknown-action (0 4 2)))
(check "an unknown expectation is refused" (complaint '(expect glory)) '(1 malformed (0 4)))
(check "a story needs cell and goal" (length (interpret '((scenario "s")) 50)) 3)

(finish-checks)
