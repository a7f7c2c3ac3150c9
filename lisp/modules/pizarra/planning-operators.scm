;; The thesis' operator files: forms (operator NAME (params (<p> TYPE) ...) (preconds FACT ...) (effects FACT ... (del
;; FACT) ...)), one after another. Nothing is declared: types and predicates are those that the operators speak of.
;;
;; (interpret DATA) answers (errors ...) or (ok (domain ...)) as (pizarra pddl-domain) does. A predicate's arguments
;; have the type `*`, which is any. (interpret DATA FACTS), FACTS being the data of a facts file, makes two complaints
;; more: about names that are no object of the facts, and about types that no object has and that look misspelt.
;; (interpret-beside FACTS DATA), DATA being those of an operator file that is wrong, answers the facts' errors as far
;; as the operators can be understood.

(define-module (pizarra planning-operators)
  #:use-module (srfi srfi-1)
  #:use-module (srfi srfi-9)
  #:use-module (pizarra forms)
  #:use-module (pizarra operators)
  #:use-module ((pizarra planning-facts) #:select (object-entries (interpret . interpret-facts)))
  #:export (interpret interpret-beside))

(define reserved '(and or not del add = when forall exists imply))

;; The predicates that operators speak of: how many arguments each has, and their names, the last first.
(define-record-type <spoken-of>
  (make-spoken-of arities names)
  spoken-of?
  (arities spoken-of-arities)
  (names spoken-of-names set-spoken-of-names!))

(define* (interpret data #:optional facts)
  (interpreting data (lambda (file) (read-file file data facts))))

(define (interpret-beside facts data)
  (let* ((domain (guessing data (lambda (file) (read-file file data #f))))
         (outcome (interpret-facts facts domain 'open)))
    (if (eq? (car outcome) 'ok) '(ok ()) outcome)))

(define (read-file file data facts)
  (let* ((predicates (make-spoken-of (make-hash-table) '()))
         (entries (and facts (object-entries facts)))
         (objects (and facts (table-of (map first entries))))
         (types-had (if facts (lset-intersection eq? (types-written data) (map second entries)) '()))
         (read-param (lambda (node) (typed-param node types-had)))
         (operators (map in-common-form
                         (read-operators (filter operator-form? (node-items file)) read-param
                                         (lambda (params) (fact-reader params predicates objects))))))
    (list 'domain 'operators (types-of operators) '() (predicates-of predicates) '() operators '())))

;; For lookups, and the names in order.
(define (table-of names)
  (let ((known (make-hash-table)))
    (for-each (lambda (name) (hash-set! known name #t)) names)
    (cons known names)))

(define (operator-form? node) (node-form? node 'operator))

;; With the absent facts, equalities and costs that only PDDL's have.
(define (in-common-form operator)
  (apply (lambda (name params preconds adds deletes) (list name params preconds '() '() adds deletes '())) operator))

;; The types that the data of an operator file name, whatever else may be wrong.
(define (types-written data)
  (define (items-of datum) (if (list? datum) datum '()))
  (define (type-of param) (and (list? param) (= (length param) 2) (second param)))
  (delete-duplicates
   (filter-map type-of
               (append-map items-of
                           (filter (lambda (part) (and (pair? part) (eq? (car part) 'params)))
                                   (append-map items-of data))))))

(define (types-of operators)
  (map (lambda (type) (list type 'object))
       (delete-duplicates (append-map (lambda (operator) (map second (second operator))) operators))))

(define (predicates-of predicates)
  (map (lambda (name) (cons name (make-list (hashq-ref (spoken-of-arities predicates) name) '*)))
       (reverse (spoken-of-names predicates))))

;; How many arguments the predicate has; its first mention says it.
(define (arity-of name count predicates)
  (let ((arities (spoken-of-arities predicates)))
    (or (hashq-ref arities name)
        (begin
          (set-spoken-of-names! predicates (cons name (spoken-of-names predicates)))
          (hashq-set! arities name count)))))

;; ---- what stands in an operator

;; A type near to those of the TYPES that objects have is a slip of the pen.
(define (typed-param node types)
  (let* ((datum (node-datum node))
         (written? (and (list? datum) (= (length datum) 2) (param? (first datum)) (symbol? (second datum))))
         (nearest (and written? (not (memq (second datum) types)) (nearest-name (second datum) types))))
    (cond ((not written?) (complain! node 'malformed "a parameter is written (<NAME> TYPE)"))
          (nearest
           (complain! (node-ref node 1) 'unknown-type "no object is of type ~a; the nearest is ~a" (second datum) nearest)
           datum)
          (else datum))))

;; OBJECTS is #f where any name may be one.
(define (fact-reader params predicates objects)
  (define (read-object node type) (object-name node params objects))
  (define read-argument (argument-reader params read-object (const #t)))
  (define (read-fact node name arguments)
    (let* ((count (length arguments))
           (arity (arity-of name count predicates)))
      (if (not (= arity count))
          (complain! node 'wrong-arity "~a has ~a argument~a elsewhere, and ~a here" name arity
                     (if (= arity 1) "" "s") count)
          (let ((terms (map (lambda (argument) (read-argument argument '*)) arguments)))
            (and (every identity terms) (cons name terms))))))
  (lambda (node items)
    (let ((name (and (pair? items) (node-datum (car items)))))
      (cond ((eq? name 'delete) (complain! node 'malformed "a deletion is written (del FACT)"))
            ((not (symbol? name)) (complain! node 'malformed "a fact is written (PREDICATE ARGUMENT ...)"))
            ((or (memq name reserved) (param? name) (pattern-variable? name))
             (complain! node 'malformed "`~a` cannot stand where a predicate is expected" name))
            (else (read-fact node name (cdr items)))))))

(define (object-name node params objects)
  (let ((name (node-datum node)))
    (cond ((pair? name) (complain! node 'malformed "an argument is a name"))
          ((pattern-variable? name) (complain! node 'malformed "a parameter is written <NAME>, not ~a" name))
          ((or (not objects) (hash-ref (car objects) name)) name)
          (else (complain! node 'unknown-object "there is no object ~s~a" name (object-meant name params (cdr objects)))))))

(define (object-meant name params objects)
  (let ((param (and (symbol? name) (string->symbol (simple-format #f "<~a>" name)))))
    (if (assq param params)
        (simple-format #f "; the parameter is written ~a" param)
        (suggestion (and (symbol? name) name) (filter symbol? objects)))))
