(use-modules (pizarra test-checks) (pizarra pddl-domain))

(define (domain . sections)
  (interpret (list (cons* 'define '(domain d) sections))))

;; The symbols and paths of what is wrong.
(define (wrong . sections)
  (let ((outcome (apply domain sections)))
    (if (eq? (car outcome) 'errors)
        (map (lambda (error) (list (car error) (caddr error))) (cdr outcome))
        outcome)))

(define predicates '(:predicates (on ?x - block ?y - block) (clear ?x - block) (empty)))
(define types '(:types block - thing thing))

(check "a whole domain"
       (domain '(:requirements :strips :typing) types '(:constants table - block) predicates
               '(:functions (total-cost) - number (weight ?x - block))
               '(:action lift :parameters (?x ?y - block)
                         :precondition (and (on ?x ?y) (not (clear ?y)) (= ?x table) (and (not (= ?x ?y))))
                         :effect (and (empty) (not (on ?x ?y)) (increase (total-cost) (weight ?x))
                                      (increase (total-cost) 2))))
       '(ok (domain d ((block thing) (thing object)) ((table block)) ((on block block) (clear block) (empty))
                    ((total-cost) (weight block))
                    ((lift ((?x block) (?y block)) ((on ?x ?y)) ((clear ?y)) ((= ?x table) (differ ?x ?y))
                           ((empty)) ((on ?x ?y)) ((weight ?x) 2)))
                    ())))

(check "a type may have several parents, and a parent needs no entry of its own"
       (list-ref (cadr (domain '(:types area - place area - surface))) 2)
       '((area place) (area surface) (place object) (surface object)))

(check "an action may lack parameters, precondition and effect"
       (list-ref (cadr (domain predicates '(:types block) '(:action rest))) 6)
       '((rest () () () () () () ())))
(check "what is required and not used does no harm" (car (domain '(:requirements :adl :fluents))) 'ok)
(check "an argument's name may come twice" (car (domain '(:predicates (in ?obj ?obj)))) 'ok)

(define (wrong-action . parts)
  (wrong types predicates (cons* ':action 'lift parts)))

(check "an unknown requirement" (wrong '(:requirements :strips :typign)) '((unknown-requirement (0 2 2))))
(check "its sentence"
       (cadr (cadr (domain '(:requirements :typign)))) "there is no requirement :typign; the nearest is :typing")
(check "what is known, where nothing is near"
       (cadr (cadr (domain '(:requirements :magic))))
       (string-append "there is no requirement :magic; there are :strips, :typing, :negative-preconditions, :equality, "
                      ":action-costs, :adl, :disjunctive-preconditions, :conditional-effects, "
                      ":existential-preconditions, :universal-preconditions, :quantified-preconditions, "
                      ":derived-predicates, ..."))
(check "the nearest of those that may be named" (cadr (cadr (domain '(:requirements :fluent))))
       "there is no requirement :fluent; the nearest is :fluents")
(check "an unknown predicate" (wrong-action ':effect '(emtpy)) '((unknown-predicate (0 4 3 0))))
(check "an unknown type" (wrong-action ':parameters '(?x - blok)) '((unknown-type (0 4 3 2))))
(check "an unknown variable" (wrong-action ':effect '(clear ?x)) '((unknown-variable (0 4 3 1))))
(check "an unknown constant" (wrong-action ':effect '(clear x)) '((unknown-object (0 4 3 1))))
(check "a wrong arity" (wrong-action ':parameters '(?x - block) ':effect '(on ?x)) '((wrong-arity (0 4 5))))
(check "an action twice" (wrong '(:action a) '(:action a)) '((repeated (0 3))))
(check "a predicate twice" (wrong '(:predicates (a) (a))) '((repeated (0 2 2))))
(check "a parameter twice" (wrong-action ':parameters '(?x ?x - block)) '((repeated (0 4 3 1))))
(check "a part twice" (wrong-action ':effect '(empty) ':effect '(empty)) '((repeated (0 4 4))))
(check "a part unknown" (wrong-action ':preconditions '(empty)) '((unknown-section (0 4 2))))
(check "a part without what belongs to it" (wrong-action ':effect) '((malformed (0 4 2))))
(check "a name for a condition" (wrong-action ':precondition 'empty) '((malformed (0 4 3))))
(check "a parameter without a question mark" (wrong-action ':parameters '(x - block)) '((malformed (0 4 3 0))))
(check "a dash without a type" (wrong-action ':parameters '(?x -)) '((malformed (0 4 3 1))))
(check "a type whose parent is wrong is a type all the same"
       (wrong '(:types a - (either b c)) '(:constants k - a)) '((unsupported (0 2 3))))
(check "a dash without names" (wrong '(:types - thing)) '((malformed (0 2 1))))
(check "either" (wrong-action ':parameters '(?x - (either block thing))) '((unsupported (0 4 3 2))))
(check "a type above itself" (wrong '(:types a - b b - a)) '((contradictory (0 2 1))))
(check "quantifiers" (wrong-action ':precondition '(forall (?x) (clear ?x))) '((unsupported (0 4 3))))
(check "conditional effects" (wrong-action ':effect '(when (empty) (empty))) '((unsupported (0 4 3))))
(check "a negation of a negation" (wrong-action ':precondition '(not (not (empty)))) '((unsupported (0 4 3 1))))
(check "a negation of a conjunction" (wrong-action ':effect '(not (and (empty)))) '((unsupported (0 4 3 1))))
(check "derived predicates and durative actions"
       (wrong '(:derived (empty) (empty)) '(:durative-action fly :effect (empty)))
       '((unsupported (0 2)) (unsupported (0 3))))
(check "a negation of two" (wrong-action ':precondition '(not (empty) (empty))) '((malformed (0 4 3))))
(check "an equality of one" (wrong-action ':precondition '(= a)) '((malformed (0 4 3))))
(check "a wrong type of argument"
       (wrong '(:types block room) '(:predicates (clear ?x - block))
              '(:action lift :parameters (?r - room) :effect (clear ?r)))
       '((wrong-type (0 4 5 1))))
(check "a cost below 0" (wrong-action ':effect '(increase (total-cost) -1)) '((bad-number (0 4 3 2))))
(check "an increase of something else" (wrong-action ':effect '(increase (fuel) 1)) '((unsupported (0 4 3 1))))
(check "a reserved predicate" (wrong '(:predicates (not ?x))) '((malformed (0 2 1))))
(check "a function that is no number" (wrong '(:functions (f) - thing)) '((unsupported (0 2 3))))
(check "an unknown section" (wrong '(:predicate (p))) '((unknown-section (0 2))))
(check "a problem" (map car (cdr (interpret '((define (problem p)))))) '(malformed))
(check "no domain" (map car (cdr (interpret '((define))))) '(malformed))
(check "all errors are found"
       (map car (wrong '(:requirements :foo) '(:types a -) '(:predicates (p ?x - b) 3)
                       '(:action a :effect (q)) '(:action b :effect (p))))
       '(unknown-requirement malformed unknown-type malformed unknown-predicate wrong-arity))

(finish-checks)
