;; The form that domain files and the thesis' operator files share:
;;
;;   (operator NAME (params (<p> TYPE) ...) (preconds FACT ...) (effects FACT ... (del FACT ...) ...))
;;
;; A deletion may also be Graphplan's (del PREDICATE ARGUMENT ...). The caller decides which types and facts there are:
;; (pizarra strips) knows declared ones, (pizarra planning-operators) those that the operators speak of.

(define-module (pizarra operators)
  #:use-module (srfi srfi-1)
  #:use-module (srfi srfi-11)
  #:use-module (pizarra forms)
  #:export (read-operators param? pattern-variable? pattern-variable argument-reader))

(define most-operators 1000)
(define most-in-operator 100)

;; ((NAME ((?VARIABLE TYPE) ...) (PRECOND ...) (ADD ...) (DELETE ...)) ...) of the forms NODES. (read-param NODE) answers
;; (<NAME> TYPE) or #f; (fact-reader PARAMS) a procedure of a node and those of the fact it says, its head and arguments,
;; that answers the fact or #f; (check-deletion NODE FACT ADDS) complains where it must.
(define* (read-operators nodes read-param fact-reader #:optional (check-deletion (const #t)))
  (refuse-repeated nodes name-of "an operator")
  (filter-map (lambda (node) (read-operator node read-param fact-reader check-deletion))
              (at-most nodes most-operators "operators")))

(define (name-of node)
  (let ((name (node-ref node 1)))
    (and name (node-datum name))))

(define (read-operator node read-param fact-reader check-deletion)
  (let ((name (symbol-at node 1 "the operator's name")))
    (and name
         (let* ((inside (node-within node (simple-format #f "in operator ~a" name)))
                (found (sections (cddr (node-items inside)) '(params preconds effects)))
                (rest-of (lambda (key) (let ((part (section-in found key)))
                                         (if part (at-most (node-rest part) most-in-operator key) '()))))
                (params (read-params (rest-of 'params) read-param))
                (read-fact (fact-reader params))
                (preconds (filter-map (lambda (node) (read-fact node (node-items node))) (rest-of 'preconds))))
           (unless (section-in found 'effects)
             (complain-missing! inside '(effects) "(effects ...) is missing before this"))
           (let-values (((adds deletes) (read-effects (rest-of 'effects) read-fact check-deletion)))
             (list name (map (lambda (param) (list (pattern-variable (first param)) (second param))) params)
                   preconds adds deletes))))))

(define (read-params nodes read-param)
  (refuse-repeated nodes (lambda (node) (and (node-ref node 0) (node-datum (node-ref node 0)))) "a parameter")
  (filter-map read-param nodes))

;; The facts added and the facts deleted.
(define (read-effects nodes read-fact check-deletion)
  (define (read-whole node) (read-fact node (node-items node)))
  (let*-values (((deletions additions) (partition (lambda (node) (eq? (node-head node) 'del)) nodes))
                ((adds) (filter-map read-whole additions)))
    (define (read-deletion node items)
      (let ((fact (read-fact node items)))
        (when fact (check-deletion node fact adds))
        fact))
    (define (read-deletions node)
      (let ((rest (node-rest node)))
        (cond ((null? rest) (list (complain! node 'malformed "a deletion is written (del FACT)")))
              ((pair? (node-datum (car rest))) (map (lambda (fact) (read-deletion fact (node-items fact))) rest))
              (else (list (read-deletion node rest))))))
    (values adds (filter identity (append-map read-deletions deletions)))))

;; ---- parameters

;; <ob1>
(define (param? name)
  (let ((text (if (symbol? name) (symbol->string name) "")))
    (and (> (string-length text) 2) (string-prefix? "<" text) (string-suffix? ">" text))))

;; ?ob1
(define (pattern-variable? name)
  (and (symbol? name) (string-prefix? "?" (symbol->string name))))

(define (pattern-variable param)
  (let ((text (symbol->string param)))
    (string->symbol (string-append "?" (substring text 1 (- (string-length text) 1))))))

;; A reader of arguments (read NODE TYPE): what is no parameter, (read-object NODE TYPE) reads; and (check-type NODE NAME
;; ITS-TYPE TYPE) says of a parameter whether it may stand there.
(define (argument-reader params read-object check-type)
  (lambda (node type)
    (let ((name (node-datum node)))
      (cond ((not (param? name)) (read-object node type))
            ((assq name params)
             => (lambda (param) (and (check-type node name (second param) type) (pattern-variable name))))
            (else
             (complain! node 'unknown-variable "there is no parameter ~a~a" name (suggestion name (map car params))))))))
