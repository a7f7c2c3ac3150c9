;; PDDL domain files: :strips :typing :negative-preconditions :equality :action-costs.
;;
;; (interpret DATA), the data of a file in lower case, answers (errors ...) or
;;   (ok (domain NAME ((TYPE PARENT) ...) ((CONSTANT TYPE) ...) ((PREDICATE TYPE ...) ...) ((FUNCTION TYPE ...) ...)
;;        (OPERATOR ...) (FACT ...)))
;; where an OPERATOR is
;;   (NAME ((?VARIABLE TYPE) ...) (FACT ...) (ABSENT-FACT ...) ((= A B) | (differ A B) ...) (ADD ...) (DELETE ...)
;;    (COST ...))
;; and a COST a whole number or (FUNCTION ARGUMENT ...). PDDL has no FACTs here; Pizarra's domain files do.

(define-module (pizarra pddl-domain)
  #:use-module (srfi srfi-1)
  #:use-module (srfi srfi-11)
  #:use-module (pizarra forms)
  #:use-module (pizarra pddl)
  #:export (interpret guess check-requirements whole-cost))

(define most-in-section 1000)
(define most-in-action 100)

(define supported '(:strips :typing :negative-preconditions :equality :action-costs))

;; Others may be named; what a file uses of them is refused where it stands.
(define other-requirements
  '(:adl :disjunctive-preconditions :conditional-effects :existential-preconditions :universal-preconditions
    :quantified-preconditions :derived-predicates :domain-axioms :fluents :numeric-fluents :object-fluents
    :goal-utilities :durative-actions :duration-inequalities :continuous-effects :timed-initial-literals :preferences
    :constraints :safety-constraints))

(define (interpret data) (interpreting data read-file))

;; As much of a domain as can be made of a file that is wrong, in which a type that is not known is #f; or #f.
(define (guess data) (guessing data read-file))

(define (read-file file)
  (let ((domain (defined file 'domain)))
    (and domain (read-domain domain))))

(define (read-domain domain)
  (let* ((found (sections (understood (cddr (node-items domain)))
                          '(:requirements :types :constants :predicates :functions :action)
                          '(:action)))
         (in (lambda (name) (nodes-in found name)))
         (types (read-types (in ':types)))
         (type-of (lambda (node) (known-type (make-vocabulary types '() '() '()) node)))
         (constants (read-declarations (in ':constants) "a constant" name-node? type-of))
         (predicates (read-skeletons (in ':predicates) "a predicate" type-of))
         (functions (read-functions (in ':functions) type-of))
         (vocabulary (make-vocabulary types predicates functions constants))
         (actions (at-most (sections-in found ':action) most-in-section "actions")))
    (check-requirements (in ':requirements))
    (refuse-repeated actions (lambda (node) (and (node-ref node 1) (node-datum (node-ref node 1)))) "an action")
    (list 'domain (node-datum (node-ref (node-ref domain 1) 1)) types constants predicates functions
          (filter-map (lambda (node) (read-action node vocabulary constants type-of)) actions)
          '())))

(define (nodes-in found name)
  (let ((section (section-in found name)))
    (if section
        (at-most (node-rest (node-within section (simple-format #f "in ~a" name))) most-in-section
                 (simple-format #f "entries in ~a" name))
        '())))

(define (check-requirements nodes)
  (for-each (lambda (node)
              (let ((name (node-datum node)))
                (unless (or (memq name supported) (memq name other-requirements))
                  (complain! node 'unknown-requirement "there is no requirement ~a~a" name
                             (suggestion (and (symbol? name) name) (append supported other-requirements))))))
            nodes))

;; ---- declarations

;; A type may have several parents, each in an entry of its own; a parent is a type by being named. One whose parent is
;; wrong is a type all the same.
(define (read-types nodes)
  (define (parent-of node)
    (if (eq? (node-head node) 'either)
        (complain! node 'unsupported "a type is one name; `either` is not understood")
        (and (name-node? node "a type") (node-datum node))))
  (let* ((declared (read-declarations nodes "a type" name-node? parent-of #:repeatable? #t))
         (pairs (filter-map (lambda (pair)
                              (and (not (eq? (first pair) 'object)) (list (first pair) (or (second pair) 'object))))
                            declared))
         (parents (lset-difference eq? (delete-duplicates (map second pairs)) (cons 'object (map first pairs)))))
    (refuse-circle nodes pairs)
    (append pairs (map (lambda (parent) (list parent 'object)) parents))))

(define (refuse-circle nodes pairs)
  (define (above type seen)
    (fold (lambda (pair seen)
            (if (and (eq? (first pair) type) (not (memq (second pair) seen)))
                (above (second pair) (cons (second pair) seen))
                seen))
          seen pairs))
  (let ((node (find (lambda (node) (memq (node-datum node) (above (node-datum node) '()))) nodes)))
    (when node
      (complain! node 'contradictory "the type ~a is above itself" (node-datum node)))))

;; ((NAME TYPE ...) ...) of nodes (NAME ?argument ... - TYPE ...).
(define (read-skeletons nodes what type-of)
  (refuse-repeated nodes node-head what)
  (filter-map (lambda (node) (read-skeleton node what type-of)) nodes))

(define (read-skeleton node what type-of)
  (let ((name (node-head node)))
    (cond ((not name) (complain! node 'malformed "~a is written (NAME ?ARGUMENT ...)" what))
          ((or (memq name '(and or not = imply exists forall when)) (pddl-variable? name))
           (complain! node 'malformed "~a cannot be the name of ~a" name what))
          (else (cons name (map second (read-declarations (node-rest node) "an argument" variable-node? type-of
                                                        #:repeatable? #t)))))))

;; Functions have the type `number`, which may be left out.
(define (read-functions nodes type-of)
  (define (number-type node)
    (unless (eq? (node-datum node) 'number)
      (complain! node 'unsupported "a function's value is a number")))
  (read-skeletons (map car (typed-nodes nodes number-type)) "a function" type-of))

;; ---- actions

(define (read-action node vocabulary constants type-of)
  (let ((name (symbol-at node 1 "the action's name")))
    (and name
         (let* ((inside (node-within node (simple-format #f "in action ~a" name)))
                (parts (read-parts (cddr (node-items inside))))
                (params (read-params (part-of parts ':parameters) type-of))
                (term (action-term (vocabulary-with vocabulary (append params constants))))
                (condition (part-of parts ':precondition))
                (effect (part-of parts ':effect))
                (literals (if condition (condition-literals vocabulary condition term) '())))
           (when effect (at-most (conjuncts effect) most-in-action "effects"))
           (when condition (at-most (conjuncts condition) most-in-action "preconditions"))
           (let-values (((adds deletes costs) (read-effects effect vocabulary term)))
             (list name params (literals-of literals 'fact) (literals-of literals 'not)
                   (filter (lambda (literal) (memq (car literal) '(= differ))) literals)
                   adds deletes costs))))))

;; ((KEYWORD . NODE) ...) of `:parameters (...) :precondition (...) :effect (...)`.
(define (read-parts nodes)
  (define known '(:parameters :precondition :effect))
  (let loop ((nodes nodes) (found '()))
    (if (null? nodes)
        found
        (let ((key (node-datum (car nodes))))
          (cond ((not (memq key known))
                 (complain! (car nodes) 'unknown-section "an action has no part ~a~a"
                            (if (symbol? key) key "like this") (suggestion (and (symbol? key) key) known))
                 (loop (if (null? (cdr nodes)) '() (cddr nodes)) found))
                ((null? (cdr nodes)) (complain! (car nodes) 'malformed "something must follow ~a" key) found)
                (else
                 (when (assq key found) (complain! (car nodes) 'repeated "there is a part ~a already" key))
                 (loop (cddr nodes) (cons (cons key (cadr nodes)) found))))))))

(define (part-of parts key)
  (let ((node (assq-ref parts key)))
    (cond ((not node) #f)
          ((list? (node-datum node)) node)
          (else (complain! node 'malformed "a list must follow ~a" key)))))

(define (read-params node type-of)
  (let ((nodes (if node (at-most (node-items node) most-in-action "parameters") '())))
    (read-declarations nodes "a parameter" variable-node? type-of)))

(define (action-term vocabulary)
  (read-term vocabulary
             (lambda (node names)
               (let* ((name (node-datum node))
                      (variable (pddl-variable? name)))
                 (complain! node (if variable 'unknown-variable 'unknown-object) "there is no ~a ~a~a"
                            (if variable "parameter" "constant") name
                            (suggestion name (filter (lambda (other) (eq? (pddl-variable? other) variable)) names)))))))

;; The facts added, the facts deleted, and what it costs.
(define (read-effects node vocabulary term)
  (define (read-effect effect)
    (case (node-head effect)
      ((increase) (let ((cost (read-increase effect vocabulary term))) (and cost (list 'cost cost))))
      ((not)
       (if (= (length (node-rest effect)) 1)
           (let ((fact (read-atom vocabulary (node-ref effect 1) term))) (and fact (list 'delete fact)))
           (complain! effect 'malformed "a deletion is written (not FACT)")))
      (else (let ((fact (read-atom vocabulary effect term))) (and fact (list 'add fact))))))
  (let ((effects (if node (filter-map read-effect (conjuncts node)) '())))
    (values (literals-of effects 'add) (literals-of effects 'delete)
            (filter-map (lambda (effect) (and (eq? (car effect) 'cost) (second effect))) effects))))

(define (read-increase node vocabulary term)
  (let ((what (node-ref node 1))
        (by (node-ref node 2)))
    (cond ((not (= (length (node-items node)) 3))
           (complain! node 'malformed "a cost is written (increase (total-cost) COST)"))
          ((not (equal? (node-datum what) '(total-cost)))
           (complain! what 'unsupported "only (total-cost) can be increased"))
          ((number? (node-datum by)) (whole-cost by))
          (else (read-cost-term vocabulary by term)))))

(define (whole-cost node)
  (let ((value (node-datum node)))
    (if (and (number? value) (integer? value) (<= 0 value 1000000000))
        (inexact->exact value)
        (complain! node 'bad-number "a cost is a whole number from 0 to 1000000000"))))
