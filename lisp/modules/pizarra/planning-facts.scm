;; The thesis' fact files: sections (types (OBJECT TYPE) ...), (initials FACT ...) and (goals FACT ...). Graphplan's own
;; way of writing them is read as well: (OBJECT TYPE) ... without a section, (preconds FACT ...), (effects FACT ...).
;;
;; (interpret DATA DOMAIN OPEN) answers (errors ...) or (ok (problem ...)) as (pizarra pddl-problem) does. Where OPEN is
;; `open`, the domain declares nothing: there may be objects of types and initial facts that no operator speaks of, as
;; long as their names are no slip of the pen.

(define-module (pizarra planning-facts)
  #:use-module (srfi srfi-1)
  #:use-module (srfi srfi-11)
  #:use-module (pizarra forms)
  #:use-module ((pizarra operators) #:select (param? pattern-variable?))
  #:export (interpret object-entries))

(define most-objects 20000)
(define known-sections '(types initials goals preconds effects))

(define (interpret data domain open)
  (interpreting data
    (lambda (file)
      (apply read-facts file (eq? open 'open) (cdr domain)))))

(define (read-facts file open? name types constants predicates functions operators facts)
  (let*-values (((forms bare-objects) (partition section? (node-items file)))
                ((found) (sections forms known-sections)))
    (let* ((objects (read-objects (at-most (append bare-objects (inside found 'types)) most-objects "objects")
                                  (map first types) constants open?))
           (term (ground-term (append constants objects)))
           (declared (table predicates))
           (read-all (lambda (open? . names)
                       (filter-map (lambda (node) (read-fact node declared term open?))
                                   (append-map (lambda (name) (inside found name)) names))))
           (initials (read-all open? 'initials 'preconds))
           (goals (read-all #f 'goals 'effects)))
      (check-goals file (or (section-in found 'goals) (section-in found 'effects))
                   (append (inside found 'goals) (inside found 'effects)))
      (list 'problem objects initials '() (delete-duplicates goals) '() 'none))))

;; Graphplan's (OBJECT TYPE) is two names; a section's items are lists, or it has none.
(define (section? node)
  (let ((datum (node-datum node)))
    (not (and (list? datum)
              (= (length datum) 2)
              (not (pair? (second datum)))
              (not (memq (first datum) known-sections))))))

(define (inside found name)
  (let ((section (section-in found name)))
    (if section (node-rest (node-within section (simple-format #f "in the ~a" name))) '())))

(define (name? datum)
  (and (or (symbol? datum) (string? datum) (number? datum))
       (not (param? datum))
       (not (pattern-variable? datum))))

;; The (NAME TYPE) ... that the data of a facts file name objects with; what is no such entry is left out.
(define (object-entries data)
  (define (entry? datum)
    (and (list? datum) (= (length datum) 2) (name? (first datum)) (symbol? (second datum))))
  (append (filter (lambda (datum) (and (entry? datum) (not (memq (first datum) known-sections)))) data)
          (append-map (lambda (datum)
                        (if (and (list? datum) (pair? datum) (eq? (first datum) 'types)) (filter entry? (cdr datum)) '()))
                      data)))

;; One of the domain's own objects may be named again with the same type.
(define (read-objects nodes types constants open?)
  (refuse-repeated nodes (lambda (node) (and (node-ref node 0) (node-datum (node-ref node 0)))) "an object")
  (filter-map (lambda (node)
                (let ((datum (node-datum node)))
                  (cond ((not (and (list? datum) (= (length datum) 2) (name? (first datum)) (symbol? (second datum))))
                         (complain! node 'malformed "an object is written (NAME TYPE)"))
                        ((member datum constants) #f)
                        ((assoc (first datum) constants)
                         => (lambda (constant)
                              (complain! node 'repeated "~a is an object of the domain already, of type ~a"
                                         (first datum) (second constant))))
                        ((or (memq (second datum) types) (and open? (not (nearest-name (second datum) types)))) datum)
                        (else
                         (complain! (node-ref node 1) 'unknown-type "there is no type ~a~a" (second datum)
                                    (suggestion (second datum) types))
                         (list (first datum) '*)))))
              nodes))

;; SECTION is one that goals stand in, or #f.
(define (check-goals file section goals)
  (define sentence "there must be at least one goal: (goals FACT ...)")
  (cond ((pair? goals) #t)
        (section (complain! section 'malformed sentence))
        (else (complain-missing! file '(goals effects) sentence))))

;; (NAME TYPE ...) by name, and the names in order.
(define (table entries)
  (let ((by-name (make-hash-table)))
    (for-each (lambda (entry) (hash-set! by-name (car entry) (cdr entry))) entries)
    (cons by-name (map car entries))))

(define (ground-term objects)
  (let ((known (table objects)))
    (lambda (node type)
      (let* ((name (node-datum node))
             (its-type (and (name? name) (hash-ref (car known) name))))
        (cond ((not (name? name))
               (complain! node 'malformed "an argument is an object's name"))
              ((not its-type)
               (complain! node 'unknown-object "there is no object ~s~a" name
                          (suggestion (and (symbol? name) name) (filter symbol? (cdr known)))))
              ((or (eq? type '*) (memq (car its-type) (list type '*))) name)
              (else
               (complain! node 'wrong-type "~a is of type ~a, and ~a must stand here" name (car its-type) type)))))))

;; The fact of NODE, or #f. One of a new predicate may stand there where OPEN? is true.
(define (read-fact node declared term open?)
  (let* ((name (node-head node))
         (types (and name (hash-ref (car declared) name)))
         (arguments (node-rest node)))
    (cond ((not name) (complain! node 'malformed "a fact is written (PREDICATE OBJECT ...)"))
          ((and (not types) (memq name '(not and or del)))
           (complain! node 'malformed "`~a` is not understood here; a fact is written (PREDICATE OBJECT ...)" name))
          ((and (not types) open? (not (nearest-name name (cdr declared))))
           (hash-set! (car declared) name (map (const '*) arguments))
           (read-arguments node name term (map (const '*) arguments)))
          ((not types)
           (complain! (node-ref node 0) 'unknown-predicate "there is no predicate ~a~a" name
                      (suggestion name (cdr declared))))
          ((not (= (length types) (length arguments)))
           (complain! node 'wrong-arity "~a takes ~a argument~a, not ~a" name (length types)
                      (if (= (length types) 1) "" "s") (length arguments)))
          (else (read-arguments node name term types)))))

(define (read-arguments node name term types)
  (let ((terms (map term (node-rest node) types)))
    (and (every identity terms) (cons name terms))))
