;; The thesis' operator files: forms (operator NAME (params (<p> TYPE) ...) (preconds FACT ...) (effects FACT ... (del
;; FACT) ...)), one after another. Nothing is declared: types and predicates are those that the operators speak of.
;;
;; (interpret DATA) answers (errors ...) or (ok (domain ...)) as (pizarra pddl-domain) does. A predicate's arguments
;; have the type `*`, which is any.

(define-module (pizarra planning-operators)
  #:use-module (srfi srfi-1)
  #:use-module (srfi srfi-11)
  #:use-module (pizarra forms)
  #:use-module ((pizarra strips) #:select (param? pattern-variable? pattern-variable))
  #:export (interpret))

(define most-operators 1000)
(define most-in-operator 100)
(define reserved '(and or not del add = when forall exists imply))

(define (interpret data)
  (interpreting data
    (lambda (file)
      (let* ((nodes (at-most (filter operator-form? (node-items file)) most-operators "operators"))
             (arities (make-hash-table))
             (operators (begin (refuse-repeated nodes name-of "an operator")
                               (filter-map (lambda (node) (read-operator node arities)) nodes))))
        (list 'domain 'operators (types-of operators) '() (predicates-of operators arities) '() operators '())))))

(define (operator-form? node) (node-form? node 'operator))

(define (name-of node)
  (let ((name (node-ref node 1)))
    (and name (node-datum name))))

(define (types-of operators)
  (map (lambda (type) (list type 'object))
       (delete-duplicates (append-map (lambda (operator) (map second (second operator))) operators))))

(define (predicates-of operators arities)
  (map (lambda (name) (cons name (make-list (hashq-ref arities name) '*)))
       (delete-duplicates
        (append-map (lambda (operator)
                      (map car (append (third operator) (sixth operator) (seventh operator))))
                    operators))))

;; ---- one operator

(define (read-operator node arities)
  (let ((name (symbol-at node 1 "the operator's name")))
    (and name
         (let* ((inside (node-within node (simple-format #f "in operator ~a" name)))
                (found (sections (cddr (node-items inside)) '(params preconds effects)))
                (rest-of (lambda (key) (let ((part (section-in found key)))
                                         (if part (at-most (node-rest part) most-in-operator key) '()))))
                (params (read-params (rest-of 'params)))
                (read-one (lambda (node items) (read-atom node items params arities)))
                (preconds (filter-map (lambda (node) (read-one node (node-items node))) (rest-of 'preconds))))
           (unless (section-in found 'effects)
             (complain! inside 'malformed "an operator has (effects ...)"))
           (let-values (((adds deletes) (read-effects (rest-of 'effects) read-one)))
             (list name (map (lambda (param) (list (pattern-variable (first param)) (second param))) params)
                   preconds '() '() adds deletes '()))))))

(define (read-params nodes)
  (refuse-repeated nodes (lambda (node) (and (node-ref node 0) (node-datum (node-ref node 0)))) "a parameter")
  (filter-map (lambda (node)
                (let ((datum (node-datum node)))
                  (if (and (list? datum) (= (length datum) 2) (param? (first datum)) (symbol? (second datum)))
                      datum
                      (complain! node 'malformed "a parameter is written (<NAME> TYPE)"))))
              nodes))

;; The fact that ITEMS of NODE say, its <parameters> as ?variables, or #f. The first mention of a predicate says how many
;; arguments it has.
(define (read-atom node items params arities)
  (let ((name (and (pair? items) (node-datum (car items)))))
    (cond ((not (symbol? name)) (complain! node 'malformed "a fact is written (PREDICATE ARGUMENT ...)"))
          ((or (memq name reserved) (param? name) (pattern-variable? name))
           (complain! node 'malformed "`~a` cannot stand where a predicate is expected" name))
          (else
           (let ((arity (hashq-ref arities name))
                 (count (length (cdr items))))
             (unless arity (hashq-set! arities name count))
             (if (and arity (not (= arity count)))
                 (complain! node 'wrong-arity "~a has ~a argument~a elsewhere, and ~a here" name arity
                            (if (= arity 1) "" "s") count)
                 (let ((terms (map (lambda (argument) (read-argument argument params)) (cdr items))))
                   (and (every identity terms) (cons name terms)))))))))

(define (read-argument node params)
  (let ((name (node-datum node)))
    (cond ((pair? name) (complain! node 'malformed "an argument is a name"))
          ((pattern-variable? name) (complain! node 'malformed "a parameter is written <NAME>, not ~a" name))
          ((not (param? name)) name)
          ((assq name params) (pattern-variable name))
          (else
           (complain! node 'unknown-variable "there is no parameter ~a~a" name (suggestion name (map car params)))))))

;; The facts added and the facts deleted: (del FACT ...) or (del PREDICATE ARGUMENT ...).
(define (read-effects nodes read-one)
  (define (read-whole node) (read-one node (node-items node)))
  (define (read-deletion node)
    (let ((rest (node-rest node)))
      (cond ((null? rest) (list (complain! node 'malformed "a deletion is written (del FACT)")))
            ((pair? (node-datum (car rest))) (map read-whole rest))
            (else (list (read-one node rest))))))
  (let-values (((deletions additions) (partition (lambda (node) (eq? (node-head node) 'del)) nodes)))
    (values (filter-map read-whole additions) (filter identity (append-map read-deletion deletions)))))
