;; The parts that PDDL's domain and problem files share: typed lists, atoms and conditions, over a vocabulary of types,
;; predicates, functions and objects. (pizarra pddl-domain) and (pizarra pddl-problem) are the two languages.
;;
;; Names come in lower case, as the reader hands them on. A type that is not known is #f, fits everywhere, and has been
;; complained about. Quantifiers, `or`, `when`, `either` and numbers other than costs are not understood.

(define-module (pizarra pddl)
  #:use-module (srfi srfi-1)
  #:use-module (srfi srfi-9)
  #:use-module (pizarra forms)
  #:export (defined understood make-vocabulary vocabulary-with subtype? known-type
            typed-nodes read-declarations pddl-variable? variable-node? name-node?
            read-term ground-term read-atom read-cost-term atom-of condition-literals literals-of conjuncts))

;; The form (define (KIND NAME) ...) that the text must be, or #f.
(define (defined file kind)
  (let* ((form (only-form file 'define))
         (named (and form (node-ref form 1))))
    (cond ((not form) #f)
          ((not (and named (eq? (node-head named) kind)))
           (complain! (or named form) 'malformed "(~a NAME) must stand here" kind))
          (else (and (symbol-at named 1 (simple-format #f "the ~a's name" kind)) form)))))

;; The sections of a file without those of PDDL that are not understood.
(define (understood nodes)
  (define others '(:durative-action :derived :axiom :process :event :constraints :safety :timeless :length))
  (filter (lambda (node)
            (or (not (memq (node-head node) others))
                (complain! node 'unsupported "~a is not understood" (node-head node))))
          nodes))

;; ---- vocabulary

(define-record-type <vocabulary>
  (new-vocabulary types ancestors predicates functions terms)
  vocabulary?
  (types vocabulary-types)            ; ((TYPE PARENT) ...)
  (ancestors vocabulary-ancestors)    ; TYPE -> itself and all above it
  (predicates vocabulary-predicates)  ; NAME -> its arguments' types
  (functions vocabulary-functions)    ; the same
  (terms vocabulary-terms))           ; ((NAME TYPE) ...), and NAME -> TYPE

;; TYPES and TERMS are ((NAME TYPE) ...), PREDICATES and FUNCTIONS ((NAME TYPE ...) ...).
(define (make-vocabulary types predicates functions terms)
  (new-vocabulary types (ancestors-of types) (table cdr predicates) (table cdr functions) (table second terms)))

;; With these objects or variables alone.
(define (vocabulary-with vocabulary terms)
  (new-vocabulary (vocabulary-types vocabulary) (vocabulary-ancestors vocabulary) (vocabulary-predicates vocabulary)
                  (vocabulary-functions vocabulary) (table second terms)))

;; The entries by name, and their names in order.
(define (table value-of entries)
  (let ((values (make-hash-table)))
    (for-each (lambda (entry) (hashq-set! values (car entry) (value-of entry))) entries)
    (cons values (map car entries))))

(define (lookup table name) (hashq-ref (car table) name #f))
(define (known? table name) (and (hashq-get-handle (car table) name) #t))
(define table-names cdr)

(define (ancestors-of types)
  (let ((found (make-hash-table)))
    (define (climb type seen)
      (if (memq type seen)
          seen
          (fold (lambda (pair seen) (if (eq? (first pair) type) (climb (second pair) seen) seen))
                (cons type seen)
                types)))
    (for-each (lambda (type) (hashq-set! found type (climb type '())))
              (cons 'object (append-map identity types)))
    found))

(define (subtype? vocabulary type wanted)
  (or (not type) (not wanted) (eq? wanted 'object) (memq wanted (hashq-ref (vocabulary-ancestors vocabulary) type '()))))

;; The type that NODE names, or #f.
(define (known-type vocabulary node)
  (let ((type (node-datum node)))
    (cond ((eq? (node-head node) 'either)
           (complain! node 'unsupported "a type is one name; `either` is not understood"))
          ((not (symbol? type)) (complain! node 'malformed "a type must be a name"))
          ((hashq-ref (vocabulary-ancestors vocabulary) type #f) type)
          (else
           (complain! node 'unknown-type "there is no type ~a~a" type
                      (suggestion type (delete-duplicates (append (map first (vocabulary-types vocabulary))
                                                                  '(object)))))))))

;; ---- typed lists

;; ((NODE . TYPE) ...) of `a b - t c`; (type-of NODE) reads a type, and what comes without one is an `object`.
(define (typed-nodes nodes type-of)
  (let loop ((nodes nodes) (waiting '()) (found '()))
    (define (with-type type)
      (append (map (lambda (node) (cons node type)) waiting) found))
    (cond ((null? nodes) (reverse (with-type 'object)))
          ((not (eq? (node-datum (car nodes)) '-))
           (loop (cdr nodes) (cons (car nodes) waiting) found))
          ((or (null? waiting) (null? (cdr nodes)))
           (complain! (car nodes) 'malformed "names come before a `-`, and their type after it")
           (loop (cdr nodes) waiting found))
          (else (loop (cddr nodes) '() (with-type (type-of (cadr nodes))))))))

;; ((NAME TYPE) ...) of a typed list. (well-named? NODE WHAT) says of a name, or complains.
(define* (read-declarations nodes what well-named? type-of #:key (repeatable? #f))
  (let ((entries (typed-nodes nodes type-of)))
    (unless repeatable? (refuse-repeated (map car entries) node-datum what))
    (filter-map (lambda (entry)
                  (and (well-named? (car entry) what) (list (node-datum (car entry)) (cdr entry))))
                entries)))

(define (pddl-variable? name)
  (and (symbol? name) (string-prefix? "?" (symbol->string name))))

(define (variable-node? node what)
  (let ((name (node-datum node)))
    (or (and (pddl-variable? name) (> (string-length (symbol->string name)) 1))
        (complain! node 'malformed "~a is written ?NAME" what))))

(define (name-node? node what)
  (let ((name (node-datum node)))
    (cond ((not (symbol? name)) (complain! node 'malformed "~a must be a name" what))
          ((pddl-variable? name) (complain! node 'malformed "~a is no variable" what))
          (else #t))))

;; ---- atoms

;; A reader of the arguments that VOCABULARY's terms are: (term NODE TYPE), or #f. (mistaken NODE NAMES) complains about
;; a name that is none of them.
(define (read-term vocabulary mistaken)
  (let ((terms (vocabulary-terms vocabulary)))
    (lambda (node type)
      (let ((name (node-datum node)))
        (cond ((not (symbol? name)) (complain! node 'malformed "an argument is a name"))
              ((not (known? terms name)) (mistaken node (table-names terms)))
              ((or (subtype? vocabulary (lookup terms name) type)
                   (and (pddl-variable? name) (subtype? vocabulary type (lookup terms name))))
               name)
              (else
               (complain! node 'wrong-type "~a is of type ~a, and ~a must stand here" name (lookup terms name)
                          type)))))))

(define (ground-term vocabulary)
  (read-term vocabulary
             (lambda (node names)
               (let ((name (node-datum node)))
                 (if (pddl-variable? name)
                     (complain! node 'not-ground "no variable may stand here")
                     (complain! node 'unknown-object "there is no object ~a~a" name (suggestion name names)))))))

;; The fact (PREDICATE ARGUMENT ...) of NODE, or #f.
(define (read-atom vocabulary node term)
  (atom-of node (vocabulary-predicates vocabulary) 'unknown-predicate "predicate" term))

;; The same for a function: (distance a b).
(define (read-cost-term vocabulary node term)
  (atom-of node (vocabulary-functions vocabulary) 'unknown-function "function" term))

(define (atom-of node declared symbol kind term)
  (let ((name (node-head node)))
    (cond ((not name) (complain! node 'malformed "a ~a with its arguments must stand here: (NAME ARGUMENT ...)" kind))
          ((known? declared name) (arguments-of node name (lookup declared name) term))
          ((memq name '(and not))
           (complain! node 'unsupported "a single fact must stand here, not `~a`" name))
          ((memq name '(or imply exists forall when assign increase decrease at-end preference))
           (complain! node 'unsupported
                      "`~a` is not understood here; facts, (not FACT), (= A B) and (and ...) are" name))
          (else
           (complain! (node-ref node 0) symbol "there is no ~a ~a~a" kind name
                      (suggestion name (table-names declared)))))))

(define (arguments-of node name types term)
  (let* ((arguments (node-rest node))
         (count (length types)))
    (if (= (length arguments) count)
        (let ((terms (map term arguments types)))
          (and (every identity terms) (cons name terms)))
        (complain! node 'wrong-arity "~a takes ~a argument~a, not ~a" name count (if (= count 1) "" "s")
                   (length arguments)))))

;; ---- conditions

;; The nodes of FACT or (and FACT ...), however deep the `and`s nest; none of ().
(define (conjuncts node)
  (cond ((null? (node-datum node)) '())
        ((eq? (node-head node) 'and) (append-map conjuncts (node-rest node)))
        (else (list node))))

;; The literals of a condition: (fact FACT), (not FACT), (= A B), (differ A B).
(define (condition-literals vocabulary node term)
  (filter-map (lambda (node) (literal vocabulary node term)) (conjuncts node)))

(define (literal vocabulary node term)
  (cond ((eq? (node-head node) '=) (equality node '= term))
        ((not (eq? (node-head node) 'not)) (tagged 'fact (read-atom vocabulary node term)))
        ((not (= (length (node-rest node)) 1)) (complain! node 'malformed "a negation is written (not FACT)"))
        ((eq? (node-head (node-ref node 1)) '=) (equality (node-ref node 1) 'differ term))
        (else (tagged 'not (read-atom vocabulary (node-ref node 1) term)))))

(define (tagged tag atom)
  (and atom (list tag atom)))

(define (equality node tag term)
  (if (= (length (node-rest node)) 2)
      (let ((terms (map (lambda (argument) (term argument #f)) (node-rest node))))
        (and (every identity terms) (cons tag terms)))
      (complain! node 'malformed "an equality is written (= A B)")))

;; The facts of the literals so tagged, each once.
(define (literals-of literals tag)
  (let ((seen (make-hash-table)))
    (filter-map (lambda (literal)
                  (and (eq? (car literal) tag)
                       (not (hash-ref seen (second literal)))
                       (hash-set! seen (second literal) #t)
                       (second literal)))
                literals)))
