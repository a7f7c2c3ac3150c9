;; STRIPS domain files: see lisp/forms/domain.hpp for the language.
;;
;; (interpret DATA), the data of a file, answers (errors ...) or
;;   (ok (domain NAME (TYPE ...) ((PREDICATE (ARGUMENT TYPE) ...) ...) ((OBJECT TYPE) ...) (FACT ...)
;;        ((OPERATOR ((?VARIABLE TYPE) ...) (PRECOND ...) (ADD ...) (DELETE ...)) ...)
;;        PERCEPTION PERCEPTION-PATH MICRO-TASKS MICRO-TASKS-PATH))
;; where the last four are () where there is no such section.

(define-module (pizarra strips)
  #:use-module (srfi srfi-1)
  #:use-module (pizarra forms)
  #:use-module (pizarra operators)
  #:export (interpret read-fact typed-term))

(define reserved '(and or not = forall exists at-least then keep wait del add))

;; Of types, predicates, objects and facts.
(define most-in-section 1000)

(define (interpret data)
  (interpreting data
    (lambda (file)
      (let ((domain (only-form file 'domain)))
        (and domain (read-domain domain))))))

(define (read-domain domain)
  (let* ((name (symbol-at domain 1 "the domain's name"))
         (found (sections (drop (node-items domain) (min 2 (length (node-items domain))))
                          '(types predicates objects facts operator perception micro-tasks)
                          '(operator)))
         (types (read-types (nodes-in found 'types)))
         (predicates (read-predicates (nodes-in found 'predicates) types))
         (objects (read-objects (nodes-in found 'objects) types))
         (facts (filter-map (lambda (node) (read-fact node predicates (ground-term objects) same-symbol))
                            (nodes-in found 'facts)))
         (operators (read-operators (sections-in found 'operator)
                                    (lambda (node) (read-typed node types "a parameter" parameter-name?))
                                    (lambda (params) (operator-facts params predicates objects))
                                    refuse-contradiction)))
    (append (list 'domain name types predicates objects facts operators)
            (handed-on found 'perception)
            (handed-on found 'micro-tasks))))

;; The items of a section that may be missing.
(define (nodes-in found name)
  (let ((section (section-in found name)))
    (if section
        (at-most (node-rest (node-within section (simple-format #f "in the ~a" name)))
                 most-in-section
                 name)
        '())))

(define (handed-on found name)
  (let ((section (section-in found name)))
    (if section (list (node-datum section) (path-to section)) (list '() '()))))

(define (read-types nodes)
  (refuse-repeated nodes node-datum "a type")
  (filter-map (lambda (node) (symbol-of node "a type")) nodes))

;; ---- names with types

;; (NAME TYPE), or #f. WELL-NAMED? says of a name, or complains.
(define (read-typed node types what well-named?)
  (if (not (and (list? (node-datum node)) (= (length (node-datum node)) 2)))
      (complain! node 'malformed "~a is written (NAME TYPE)" what)
      (let ((name (symbol-at node 0 what))
            (type (symbol-at node 1 "a type")))
        (when (and type (not (memq type types)))
          (complain! (node-ref node 1) 'unknown-type "there is no type ~a~a" type (suggestion type types)))
        (and name type (well-named? (node-ref node 0)) (list name type)))))

(define (any-name? node) #t)

(define (first-datum node)
  (and (node-ref node 0) (node-datum (node-ref node 0))))

(define (read-objects nodes types)
  (refuse-repeated nodes first-datum "an object")
  (filter-map (lambda (node) (read-typed node types "an object" constant-name?)) nodes))

(define (constant-name? node)
  (or (not (or (param? (node-datum node)) (pattern-variable? (node-datum node))))
      (complain! node 'malformed "an object's name is no variable")))

(define (read-predicates nodes types)
  (refuse-repeated nodes node-head "a predicate")
  (filter-map (lambda (node) (read-predicate node types)) nodes))

(define (read-predicate node types)
  (let ((name (node-head node)))
    (cond ((not name) (complain! node 'malformed "a predicate is written (NAME (ARGUMENT TYPE) ...)"))
          ((memq name reserved) (complain! node 'malformed "~a cannot be a predicate's name" name))
          (else
           (refuse-repeated (node-rest node) first-datum "an argument")
           (cons name (filter-map (lambda (argument) (read-typed argument types "an argument" any-name?))
                                  (node-rest node)))))))

;; ---- facts

;; The fact of NODE in PREDICATES, or #f with complaints. (term NODE TYPE) reads an argument; (find-it NAME NAMES) says
;; which of the predicates' names is meant, or #f.
(define (read-fact node predicates term find-it)
  (fact-of node (node-items node) predicates term find-it))

;; The same where the fact is only some of the node's items.
(define (fact-of node items predicates term find-it)
  (let* ((first-item (and (pair? items) (node-datum (car items))))
         (head (and (symbol? first-item) first-item))
         (names (map car predicates))
         (name (and head (find-it head names))))
    (cond ((not head) (complain! node 'malformed "a fact is written (PREDICATE ARGUMENT ...)"))
          ((and (not name) (eq? head 'not))
           (complain! (car items) 'unknown-predicate
                      "`not` cannot stand here: an effect that ends a fact is (del FACT)"))
          ((not name)
           (complain! (car items) 'unknown-predicate "there is no predicate ~a~a" head (suggestion head names)))
          (else (read-arguments node (cdr items) name (assq-ref predicates name) term)))))

(define (read-arguments node arguments name declared term)
  (if (= (length arguments) (length declared))
      (let ((terms (map (lambda (argument typed) (term argument (second typed))) arguments declared)))
        (and (every identity terms) (cons name terms)))
      (complain! node 'wrong-arity "~a takes ~a, not ~a" name (count-of declared) (length arguments))))

(define (count-of declared)
  (let ((names (map car declared)))
    (case (length names)
      ((0) "no arguments")
      ((1) (simple-format #f "1 argument (~a)" (car names)))
      (else (simple-format #f "~a arguments ~a" (length names) names)))))

(define (same-symbol name names)
  (and (memq name names) name))

;; Arguments that are the domain's own objects.
(define (ground-term objects)
  (lambda (node type)
    (let ((name (node-datum node)))
      (cond ((not (symbol? name)) (complain! node 'malformed "an argument is a name"))
            ((or (param? name) (pattern-variable? name))
             (complain! node 'not-ground "no variable may stand here"))
            ((not (assq name objects))
             (complain! node 'unknown-object "there is no object ~a~a" name (suggestion name (map car objects))))
            (else (typed-term node name (second (assq name objects)) type))))))

(define (typed-term node name its-type type)
  (if (eq? its-type type)
      name
      (complain! node 'wrong-type "~a is of type ~a, and ~a must stand here" name its-type type)))

;; ---- operators

(define (parameter-name? node)
  (or (param? (node-datum node))
      (complain! node 'malformed "a parameter is written <~a>"
                 (string-trim (simple-format #f "~a" (node-datum node)) #\?))))

;; Arguments are parameters or the domain's own objects.
(define (operator-facts params predicates objects)
  (let ((term (argument-reader params (ground-term objects) typed-term)))
    (lambda (node items) (fact-of node items predicates term same-symbol))))

(define (refuse-contradiction node fact adds)
  (when (member fact adds)
    (complain! node 'contradictory-effect "this is both added and deleted")))
