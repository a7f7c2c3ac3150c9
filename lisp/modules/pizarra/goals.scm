;; Goals: FACT, (and FACT ...) or several FACTs.
;;
;; (interpret DATA PREDICATES OBJECTS OPEN) answers (ok (FACT ...)) or (errors ...). PREDICATES and OBJECTS are as
;; strips returns them; where OPEN is `open`, a name that OBJECTS does not hold may be any object.

(define-module (pizarra goals)
  #:use-module (srfi srfi-1)
  #:use-module (srfi srfi-11)
  #:use-module (pizarra forms)
  #:use-module ((pizarra operators) #:select (param? pattern-variable?))
  #:use-module ((pizarra strips) #:select (read-fact typed-term))
  #:export (interpret))

(define most-facts 500)

(define (interpret data predicates objects open)
  (interpreting data
    (lambda (text)
      (let* ((nodes (at-most (goal-nodes text) most-facts "facts in a goal"))
             (term (goal-term objects (eq? open 'open)))
             (read-one (lambda (node) (read-fact node predicates term find-name))))
        (when (null? nodes)
          (complain! (if (null? (node-items text)) text (car (node-items text)))
                     'malformed "a goal is FACT, (and FACT ...) or several FACTs"))
        (let-values (((negated wanted) (partition (lambda (node) (headed? node 'not)) nodes)))
          (let ((facts (filter-map read-one wanted)))
            (for-each (lambda (node) (refuse-negated node read-one facts)) negated)
            (delete-duplicates facts)))))))

;; The nodes of the facts; an `and` may stand alone only.
(define (goal-nodes text)
  (let ((items (node-items text)))
    (if (and (= (length items) 1) (headed? (car items) 'and))
        (node-rest (node-within (car items) "in the goal (and ...)"))
        items)))

(define (headed? node name)
  (and (node-head node) (same-name? (node-head node) name)))

;; STRIPS goals hold only what shall be true.
(define (refuse-negated node read-one facts)
  (if (= (length (node-items node)) 2)
      (let ((fact (read-one (node-ref node 1))))
        (cond ((not fact) #f)
              ((member fact facts)
               (complain! node 'contradictory "the goal wants ~a and its contrary" fact))
              (else (complain! node 'negated "a goal says what shall be true, never what shall not"))))
      (complain! node 'malformed "a negation is written (not FACT)")))

(define (goal-term objects open?)
  (let ((names (map car objects)))
    (lambda (node type)
      (let* ((name (node-datum node))
             (known (and (or (symbol? name) (string? name)) (find-name name names))))
        (cond ((not (or (symbol? name) (string? name))) (complain! node 'malformed "an argument is an object's name"))
              ((or (param? name) (pattern-variable? name))
               (complain! node 'not-ground "a goal names objects, and ~a is a variable" name))
              (known (typed-term node known (second (assq known objects)) type))
              ((not open?)
               (complain! node 'unknown-object "nothing is called ~a~a" name (suggestion name names)))
              ((object-name? name) (if (string? name) (string->symbol name) name))
              (else (complain! node 'malformed "no object can be called ~a" name)))))))
