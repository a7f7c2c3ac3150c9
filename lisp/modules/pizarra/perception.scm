;;; Perception rules: what is measured becomes the predicates of a domain.
;;;
;;; A perception section is data, interpreted here and never evaluated:
;;;
;;;   (perception
;;;     (sees OBJECT)                              ; the type of whatever the eyes can name
;;;     (constant cube 60)                         ; a number the rules may use by its name
;;;     (fact (spot place-1 450 -200))             ; something that always holds
;;;     (rule (on ?a ?b) CONDITION ...))           ; the rules, in this order
;;;
;;; A rule sees what is measured, the section's facts, and what the rules before it found. Its conditions, in order:
;;;
;;;   (seen ?a ?x ?y ?z)          some fact fits; `?` fits anything, a ?variable keeps its value within the rule
;;;   (< E E) <= > >= = /=        numbers compare; = and /= compare names too
;;;   (not CONDITION ...)         the conditions have no common answer; variables first met inside stand for anything
;;;   (was FACT)                  it was believed before: for hysteresis
;;;
;;; An expression E is a number, a constant, a ?variable, (+ E ...), (- E E), (* E ...), (abs E), (min E ...),
;;; (max E ...), or (if CONDITION E E).

(define-module (pizarra perception)
  #:use-module (srfi srfi-1)
  #:use-module (ice-9 control)
  #:export (interpret perceive))

(define comparisons '(< <= > >= = /=))
(define most-facts 2000)                ; that the rules may find in one look
(define most-tries 100000)              ; facts that one look may try on patterns

(define (variable? x)
  (and (symbol? x) (char=? (string-ref (symbol->string x) 0) #\?)))

;; Paths are kept innermost index first and written the other way round.
(define (problem symbol sentence path context)
  (list symbol sentence (reverse path) context))

;; (interpret DATA PREDICATES), DATA a domain file's and PREDICATES ((name arity) ...), finds, checks and normalises its
;; section: (ok ((section SECTION) (sees TYPE) (constants (NAME NUMBER) ...) (facts FACT ...))) or (errors ...).
(define (interpret data predicates)
  (let* ((form-index (list-index (lambda (form) (and (pair? form) (eq? (car form) 'domain))) data))
         (form (and form-index (list-ref data form-index)))
         (index (and form (list-index (lambda (part) (and (pair? part) (eq? (car part) 'perception))) form))))
    (if (not index)
        (list 'errors (problem 'missing-section "a domain needs a section (perception ...)"
                               (if form (list form-index) '()) '()))
        (let* ((section (list-ref form index))
               (problems (check-perception section predicates)))
          (if (null? problems)
              (list 'ok (cons (list 'section section) (perception-data section)))
              (cons 'errors
                    (map (lambda (found)
                           (list (first found) (second found) (cons* form-index index (third found)) (fourth found)))
                         problems)))))))

;;; ---- checking: a list of (symbol sentence path context), paths from the section's own list ----

(define (check-perception section predicates)
  (if (and (pair? section) (eq? (car section) 'perception))
      (let ((constants (section-constants section)))
        (append-map (lambda (part index) (check-part part (list index) constants predicates))
                    (cdr section)
                    (iota (length (cdr section)) 1)))
      (list (problem 'malformed "a perception section is (perception PART ...)" '() '()))))

(define (check-part part path constants predicates)
  (define (wrong sentence) (list (problem 'malformed sentence path '("in the perception section"))))
  (cond
   ((not (and (list? part) (pair? part))) (wrong "a part is sees, constant, fact or rule"))
   (else
    (case (car part)
      ((sees) (if (and (= (length part) 2) (symbol? (cadr part))) '() (wrong "sees is (sees TYPE)")))
      ((constant)
       (if (and (= (length part) 3) (symbol? (cadr part)) (number? (caddr part)))
           '()
           (wrong "a constant is (constant NAME NUMBER)")))
      ((fact)
       (if (and (= (length part) 2) (pattern? (cadr part)) (not (any variable? (cadr part))))
           '()
           (wrong "a fact is (fact (NAME VALUE ...)) without variables")))
      ((rule) (check-rule part path constants predicates))
      (else (wrong "a part is sees, constant, fact or rule"))))))

(define (pattern? x)
  (and (list? x) (pair? x) (symbol? (car x)) (not (variable? (car x))) (every atom? (cdr x))))

(define (atom? x) (or (symbol? x) (number? x) (string? x)))

(define (check-rule rule path constants predicates)
  (if (and (>= (length rule) 2) (pattern? (cadr rule)))
      (let* ((head (cadr rule))
             (context (list (string-append "in the rule for " (symbol->string (car head)))))
             (known (assq (car head) predicates)))
        (append
         (cond
          ((not known) '())             ; a rule may find what only later rules use
          ((= (cadr known) (length (cdr head))) '())
          (else (list (problem 'wrong-arity
                               (string-append (symbol->string (car head)) " has "
                                              (number->string (cadr known)) " arguments in (predicates ...)")
                               (cons 1 path) context))))
         (let loop ((conditions (cddr rule)) (index 2) (bound '()) (problems '()))
           (if (null? conditions)
               (append problems
                       (append-map (lambda (argument position)
                                     (if (and (variable? argument) (not (memq argument bound)))
                                         (list (problem 'unbound-variable
                                                        (string-append "no condition gives "
                                                                       (symbol->string argument) " a value")
                                                        (cons* position 1 path) context))
                                         '()))
                                   (cdr head) (iota (length (cdr head)) 1)))
               (let ((condition (car conditions)))
                 (loop (cdr conditions) (+ index 1) (bound-after condition bound)
                       (append problems
                               (check-condition condition (cons index path) bound constants context))))))))
      (list (problem 'malformed "a rule is (rule (PREDICATE ARGUMENT ...) CONDITION ...)" path
                     '("in the perception section")))))

(define (bound-after condition bound)
  (if (and (pattern? condition) (not (memq (car condition) (append '(not was) comparisons))))
      (append (filter (lambda (x) (and (variable? x) (not (eq? x '?)))) (cdr condition)) bound)
      bound))

(define (check-condition condition path bound constants context)
  (define (wrong sentence) (list (problem 'malformed sentence path context)))
  (cond
   ((not (and (list? condition) (pair? condition) (symbol? (car condition))))
    (wrong "a condition is a pattern, a comparison, (not ...) or (was FACT)"))
   ((memq (car condition) comparisons)
    (if (= (length condition) 3)
        (append (check-expression (cadr condition) (cons 1 path) bound constants context
                                  (memq (car condition) '(= /=)))
                (check-expression (caddr condition) (cons 2 path) bound constants context
                                  (memq (car condition) '(= /=))))
        (wrong "a comparison has two sides")))
   ((eq? (car condition) 'not)
    (let loop ((inner (cdr condition)) (index 1) (bound bound) (problems '()))
      (if (null? inner)
          (if (null? (cdr condition)) (wrong "(not) needs a condition") problems)
          (loop (cdr inner) (+ index 1) (bound-after (car inner) bound)
                (append problems (check-condition (car inner) (cons index path) bound constants context))))))
   ((eq? (car condition) 'was)
    (if (and (= (length condition) 2) (pattern? (cadr condition)))
        '()
        (wrong "was is (was FACT)")))
   ((pattern? condition) '())
   (else (wrong "a pattern holds names, numbers, strings and ?variables only"))))

(define (check-expression x path bound constants context names?)
  (define (wrong symbol sentence) (list (problem symbol sentence path context)))
  (cond
   ((number? x) '())
   ((variable? x)
    (if (memq x bound)
        '()
        (wrong 'unbound-variable (string-append "no condition before gives " (symbol->string x) " a value"))))
   ((symbol? x)
    (if (or names? (assq x constants))
        '()
        (wrong 'unknown-constant (string-append "no constant is called " (symbol->string x)))))
   ((not (and (list? x) (pair? x))) (wrong 'malformed "an expression is a number, a name or (OPERATOR E ...)"))
   ((and (eq? (car x) 'if) (= (length x) 4))
    (append (check-condition (cadr x) (cons 1 path) bound constants context)
            (check-expression (caddr x) (cons 2 path) bound constants context #f)
            (check-expression (cadddr x) (cons 3 path) bound constants context #f)))
   ((or (and (memq (car x) '(+ * min max)) (>= (length x) 2))
        (and (eq? (car x) '-) (= (length x) 3))
        (and (eq? (car x) 'abs) (= (length x) 2)))
    (append-map (lambda (e index) (check-expression e (cons index path) bound constants context #f))
                (cdr x) (iota (length (cdr x)) 1)))
   (else (wrong 'malformed "the operators are + - * abs min max and if, with their right number of arguments"))))

;;; ---- what the section says besides its rules ----

(define (section-constants section)
  (filter-map (lambda (part)
                (and (list? part) (= (length part) 3) (eq? (car part) 'constant)
                     (cons (cadr part) (caddr part))))
              (cdr section)))

(define (section-parts section name)
  (filter (lambda (part) (and (pair? part) (eq? (car part) name))) (cdr section)))

(define (perception-data section)
  (let ((sees (section-parts section 'sees)))
    (list (if (null? sees) '(sees OBJECT) (car sees))
          (cons 'constants (map cdr (section-parts section 'constant)))
          (cons 'facts (map cadr (section-parts section 'fact))))))

;;; ---- interpreting ----
;;; Each rule becomes a closure once; the section is kept, since the same one comes with every frame. An environment is
;;; an association list from variable to value; a condition calls `emit` once for each way to hold, until emit answers
;;; true, and then answers true itself.

(define compiled-section #f)
(define compiled-rules '())
(define compiled-facts '())

(define (compile-section! section)
  (unless (equal? section compiled-section)
    (let ((constants (section-constants section)))
      (set! compiled-rules
            (map (lambda (rule)
                   (cons (cadr rule) (compile-conditions (cddr rule) constants)))
                 (section-parts section 'rule)))
      (set! compiled-facts (map cadr (section-parts section 'fact)))
      (set! compiled-section section))))

;; World: a box of an association list from predicate name to its facts, and the earlier beliefs as such a list.
(define (facts-of world name)
  (let ((entry (assq name world)))
    (if entry (cdr entry) '())))

(define (add-fact world fact)
  (let ((entry (assq (car fact) world)))
    (if entry
        (map (lambda (e) (if (eq? e entry) (cons (car e) (append (cdr e) (list fact))) e)) world)
        (append world (list (list (car fact) fact))))))

(define (match-arguments pattern values env)
  (cond
   ((null? pattern) (and (null? values) env))
   ((null? values) #f)
   (else
    (let ((p (car pattern)) (v (car values)))
      (cond
       ((eq? p '?) (match-arguments (cdr pattern) (cdr values) env))
       ((variable? p)
        (let ((bound (assq p env)))
          (cond
           ((not bound) (match-arguments (cdr pattern) (cdr values) (acons p v env)))
           ((same? (cdr bound) v) (match-arguments (cdr pattern) (cdr values) env))
           (else #f))))
       ((same? p v) (match-arguments (cdr pattern) (cdr values) env))
       (else #f))))))

(define (same? a b)
  (if (and (number? a) (number? b)) (= a b) (equal? a b)))

(define (compile-conditions conditions constants)
  (if (null? conditions)
      (lambda (env world was emit) (emit env))
      (let ((first (compile-condition (car conditions) constants))
            (rest (compile-conditions (cdr conditions) constants)))
        (lambda (env world was emit)
          (first env world was (lambda (env) (rest env world was emit)))))))

(define (compile-pattern pattern select)
  (let ((name (car pattern)) (arguments (cdr pattern)))
    (lambda (env world was emit)
      (any (lambda (fact)
             (count-try!)
             (let ((extended (match-arguments arguments (cdr fact) env)))
               (and extended (emit extended))))
           (facts-of (select world was) name)))))

(define (holds? condition env world was)
  (condition env world was (lambda (env) #t)))

(define (compile-condition condition constants)
  (case (car condition)
    ((not)
     (let ((inner (compile-conditions (cdr condition) constants)))
       (lambda (env world was emit)
         (and (not (holds? inner env world was)) (emit env)))))
    ((was)
     (let ((inner (compile-pattern (cadr condition) (lambda (world was) was))))
       (lambda (env world was emit)
         (and (holds? inner env world was) (emit env)))))
    ((< <= > >= = /=)
     (let ((left (compile-expression (cadr condition) constants))
           (right (compile-expression (caddr condition) constants))
           (compare (comparison (car condition))))
       (lambda (env world was emit)
         (and (compare (left env world was) (right env world was)) (emit env)))))
    (else (compile-pattern condition (lambda (world was) world)))))

(define (comparison name)
  (define (numeric compare) (lambda (a b) (and (number? a) (number? b) (compare a b))))
  (case name
    ((<) (numeric <))
    ((<=) (numeric <=))
    ((>) (numeric >))
    ((>=) (numeric >=))
    ((=) same?)
    (else (lambda (a b) (not (same? a b))))))

;; An expression over something that is no number has no value (#f), and no comparison of size holds for it.
(define (compile-expression x constants)
  (define (arithmetic procedure)
    (let ((parts (map (lambda (e) (compile-expression e constants)) (cdr x))))
      (lambda (env world was)
        (let ((values (map (lambda (part) (part env world was)) parts)))
          (and (every number? values) (apply procedure values))))))
  (cond
   ((variable? x) (lambda (env world was) (let ((bound (assq x env))) (and bound (cdr bound)))))
   ((symbol? x)
    (let ((constant (assq x constants)))
      (let ((value (if constant (cdr constant) x)))
        (lambda (env world was) value))))
   ((not (pair? x)) (lambda (env world was) x))
   ((eq? (car x) 'if)
    (let ((condition (compile-condition (cadr x) constants))
          (then (compile-expression (caddr x) constants))
          (otherwise (compile-expression (cadddr x) constants)))
      (lambda (env world was)
        (if (holds? condition env world was) (then env world was) (otherwise env world was)))))
   (else
    (arithmetic (case (car x)
                  ((+) +) ((-) -) ((*) *) ((abs) abs) ((min) min) (else max))))))

(define (instantiate head env)
  (cons (car head)
        (map (lambda (x) (let ((bound (and (variable? x) (assq x env)))) (if bound (cdr bound) x))) (cdr head))))

;; Rules are written by people, and a join grows with the power of its patterns: a look has so many tries.
(define tries-left 0)
(define facts-left 0)
(define give-up #f)                     ; takes the sentence's end; leaves the look

(define (count-try!)
  (set! tries-left (- tries-left 1))
  (when (negative? tries-left)
    (give-up (simple-format #f "goes beyond the ~a tries that one look may take" most-tries))))

(define (count-fact!)
  (set! facts-left (- facts-left 1))
  (when (negative? facts-left)
    (give-up (simple-format #f "goes beyond the ~a facts that may be found in one look" most-facts))))

(define (apply-rule rule world was)
  (let ((known (make-hash-table)) (found '()))
    ((cdr rule) '() world was
     (lambda (env)
       (let ((fact (instantiate (car rule) env)))
         (unless (hash-ref known fact)
           (hash-set! known fact #t)
           (set! found (cons fact found))
           (count-fact!))
         #f)))
    (reverse found)))

;; What APPLY answers, or (fail too-much-work SENTENCE HEAD).
(define (within-bounds head apply)
  (let/ec leave
    (set! give-up
          (lambda (what)
            (leave (list 'fail 'too-much-work
                         (simple-format #f "the rule for ~a ~a" (car head) what)
                         head))))
    (apply)))

;; (perceive SECTION MEASURED BELIEVED) -> (ok (FACT ...)), what the rules find in the order in which it was found, or
;; (fail too-much-work SENTENCE HEAD) about the rule that was being followed when the bound was reached.
(define (perceive section measured believed)
  (compile-section! section)
  (set! tries-left most-tries)
  (set! facts-left most-facts)
  (let ((was (fold (lambda (fact world) (add-fact world fact)) '() believed)))
    (let loop ((rules compiled-rules)
               (world (fold (lambda (fact world) (add-fact world fact)) '() (append compiled-facts measured)))
               (found '()))
      (if (null? rules)
          (list 'ok found)
          (let ((outcome (within-bounds (caar rules) (lambda () (list 'ok (apply-rule (car rules) world was))))))
            (if (eq? (car outcome) 'fail)
                outcome
                (let ((new (filter (lambda (fact) (not (member fact found))) (cadr outcome))))
                  (loop (cdr rules)
                        (fold (lambda (fact world) (add-fact world fact)) world new)
                        (append found new)))))))))
