;; Goals: what shall hold, and how long it is cared for.
;;
;;   FACT    (and G ...)    (or G ...)    (not G)    (= A B)
;;   (forall (?x TYPE) G)   (exists (?x TYPE) G)    (at-least N (?x TYPE) G)
;;
;; A goal is one G or several; or stages, (then G G ...), each of which is to hold before the next is pursued; or
;; (keep G ...), which is built again whenever it falls; and any of them with (wait SECONDS), for which a missing object
;; is waited for.
;;
;; (interpret DATA PREDICATES OBJECTS OPEN) answers (ok (FORM ...)) or (errors ...): the forms with their names as they
;; are known, the variables as <x>, an outer `and` taken apart. PREDICATES and OBJECTS are as strips returns them; where
;; OPEN is `open`, a name that OBJECTS does not hold may be any object.

(define-module (pizarra goals)
  #:use-module (srfi srfi-1)
  #:use-module (pizarra forms)
  #:use-module ((pizarra operators) #:select (param? pattern-variable?))
  #:use-module ((pizarra strips) #:select (read-fact typed-term))
  #:export (interpret))

(define most-facts 500)
(define most-counted 1000)
(define longest-wait-s 86400)

(define (interpret data predicates objects open)
  (interpreting data
    (lambda (text)
      (let* ((types (delete-duplicates (append (map second objects)
                                               (append-map (lambda (predicate) (map second (cdr predicate))) predicates))))
             (read-in (lambda (variables)
                        (let ((term (goal-term objects variables (eq? open 'open))))
                          (lambda (node) (read-fact node predicates term find-name)))))
             (read-one (lambda (node) (read-form node '() read-in types)))
             (all (at-most (node-items text) most-facts "facts in a goal"))
             (waits (filter (lambda (node) (headed? node 'wait)) all))
             (nodes (remove (lambda (node) (headed? node 'wait)) all)))
        (when (null? nodes)
          (complain! (if (null? all) text (car all)) 'malformed "a goal is FACT, (and FACT ...) or several FACTs"))
        (append (read-whole nodes read-one) (read-wait waits))))))

(define (headed? node name)
  (and (node-head node) (same-name? (node-head node) name)))

;; Stages and what is kept stand alone; what else there is, is wanted together.
(define (read-whole nodes read-one)
  (let ((only (and (pair? nodes) (null? (cdr nodes)) (car nodes))))
    (cond ((and only (headed? only 'then))
           (let ((stages (node-rest (node-within only "in the goal (then ...)"))))
             (when (< (length stages) 2)
               (complain! only 'malformed "stages are written (then GOAL GOAL ...)"))
             (list (cons 'then (map (lambda (stage) (together (list stage) read-one)) stages)))))
          ((and only (headed? only 'keep))
           (let ((kept (node-rest (node-within only "in the goal (keep ...)"))))
             (when (null? kept) (complain! only 'malformed "a goal that is kept is written (keep GOAL ...)"))
             (list (cons 'keep (conjuncts kept read-one)))))
          (else (conjuncts nodes read-one)))))

;; One form of several.
(define (together nodes read-one)
  (let ((forms (conjuncts nodes read-one)))
    (if (= (length forms) 1) (car forms) (cons 'and forms))))

(define (conjuncts nodes read-one)
  (let* ((parts (append-map parts-of nodes))
         (read (map read-one parts))
         (forms (delete-duplicates (filter identity read))))
    (for-each (lambda (node form)
                (when (and form (eq? (car form) 'not) (member (second form) forms))
                  (complain! node 'contradictory "the goal wants ~a and its contrary" (second form))))
              parts read)
    forms))

(define (parts-of node)
  (if (and (headed? node 'and) (pair? (node-rest node)))
      (append-map parts-of (node-rest (node-within node "in the goal (and ...)")))
      (list node)))

(define (read-wait nodes)
  (cond ((null? nodes) '())
        ((pair? (cdr nodes)) (complain! (cadr nodes) 'repeated "(wait SECONDS) stands once") '())
        (else
         (let ((seconds (and (= (length (node-items (car nodes))) 2) (node-datum (node-ref (car nodes) 1)))))
           (if (and (real? seconds) (<= 0 seconds longest-wait-s))
               (list (list 'wait seconds))
               (begin
                 (complain! (car nodes) 'malformed "it is written (wait SECONDS), of 0 to ~a" longest-wait-s)
                 '()))))))

;; ---- one form

;; VARIABLES is ((<x> TYPE) ...).
(define (read-form node variables read-in types)
  (define (read-inner node) (read-form node variables read-in types))
  (define (read-parts name)
    (let ((parts (node-rest node)))
      (if (null? parts)
          (complain! node 'malformed "it is written (~a GOAL ...)" name)
          (let ((read (map read-inner parts)))
            (and (every identity read) (cons name read))))))
  (cond ((headed? node 'and) (read-parts 'and))
        ((headed? node 'or) (read-parts 'or))
        ((headed? node 'not)
         (if (= (length (node-items node)) 2)
             (let ((inner (read-inner (node-ref node 1))))
               (and inner (list 'not inner)))
             (complain! node 'malformed "a negation is written (not FACT)")))
        ((headed? node '=) (read-equality node variables))
        ((headed? node 'forall) (read-quantified node 'forall 1 variables read-in types))
        ((headed? node 'exists) (read-quantified node 'exists 1 variables read-in types))
        ((headed? node 'at-least) (read-counted node variables read-in types))
        ((any (lambda (name) (headed? node name)) '(then keep wait))
         (complain! node 'malformed "(~a ...) stands around a whole goal, not within one" (node-head node)))
        (else ((read-in variables) node))))

(define (read-equality node variables)
  (define (name-of part)
    (let ((name (node-datum part)))
      (cond ((and (symbol? name) (known-variable name variables)) => first)
            ((and (symbol? name) (not (variable-name? name))) name)
            (else (complain! part 'not-ground "a name, or a variable of this goal, must stand here")))))
  (if (= (length (node-items node)) 3)
      (let ((a (name-of (node-ref node 1))) (b (name-of (node-ref node 2))))
        (and a b (list '= a b)))
      (complain! node 'malformed "an equality is written (= NAME NAME)")))

(define (read-counted node variables read-in types)
  (let ((count (and (node-ref node 1) (node-datum (node-ref node 1)))))
    (if (and (exact-integer? count) (<= 1 count most-counted))
        (let ((read (read-quantified node 'at-least 2 variables read-in types)))
          (and read (cons* 'at-least count (cdr read))))
        (complain! node 'malformed "it is written (at-least NUMBER (?x TYPE) GOAL), the number from 1"))))

;; (NAME (<x> TYPE) GOAL), of which the variable stands at INDEX.
(define (read-quantified node name index variables read-in types)
  (let* ((declared (node-ref node index))
         (body (node-ref node (+ index 1)))
         (pair (and declared (node-datum declared)))
         (sound (and body (= (length (node-items node)) (+ index 2))
                     (list? pair) (= (length pair) 2) (symbol? (first pair)) (variable-name? (first pair))
                     (symbol? (second pair)))))
    (if (not sound)
        (complain! node 'malformed "it is written (~a~a (?x TYPE) GOAL)" name (if (= index 2) " NUMBER" ""))
        (let ((type (find-name (second pair) types)))
          (if (not type)
              (complain! (node-ref declared 1) 'unknown-type "there is no type ~a~a" (second pair)
                         (suggestion (second pair) types))
              (let* ((variable (list (angled (first pair)) type))
                     (inner (read-form body (cons variable variables) read-in types)))
                (and inner (list name variable inner))))))))

;; ---- names

(define (variable-name? name) (or (param? name) (pattern-variable? name)))

;; <x> of ?x.
(define (angled name)
  (if (pattern-variable? name)
      (string->symbol (string-append "<" (substring (symbol->string name) 1) ">"))
      name))

(define (known-variable name variables)
  (and (variable-name? name) (assq (angled name) variables)))

(define (goal-term objects variables open?)
  (let ((names (map car objects)))
    (lambda (node type)
      (let* ((name (node-datum node))
             (variable (and (symbol? name) (known-variable name variables)))
             (known (and (or (symbol? name) (string? name)) (find-name name names))))
        (cond (variable (typed-term node (first variable) (second variable) type))
              ((not (or (symbol? name) (string? name))) (complain! node 'malformed "an argument is an object's name"))
              ((variable-name? name)
               (complain! node 'not-ground "a goal names objects, and ~a is a variable" name))
              (known (typed-term node known (second (assq known objects)) type))
              ((not open?)
               (complain! node 'unknown-object "nothing is called ~a~a" name (suggestion name names)))
              ((object-name? name) (if (string? name) (string->symbol name) name))
              (else (complain! node 'malformed "no object can be called ~a" name)))))))
