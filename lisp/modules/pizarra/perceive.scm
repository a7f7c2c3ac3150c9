;;; Perception rules at work: measurements in, predicates out. (pizarra perception) describes the language and checks a
;;; section; what comes here has been checked.
;;;
;;; Each rule becomes a closure once; the section is kept and has a number, since every look needs it. An environment is
;;; an association list from variable to value; a condition calls `emit` once for each way to hold, until emit answers
;;; true, and then answers true itself.

(define-module (pizarra perceive)
  #:use-module (srfi srfi-1)
  #:use-module (ice-9 control)
  #:export (perceive section-number rule-variable? comparisons section-constants section-parts))

(define comparisons '(< <= > >= = /=))
(define most-facts 2000)                ; that the rules may find in one look
(define most-tries 100000)              ; facts that one look may try on patterns

(define (rule-variable? x)
  (and (symbol? x) (char=? (string-ref (symbol->string x) 0) #\?)))

(define (section-constants section)
  (filter-map (lambda (part)
                (and (list? part) (= (length part) 3) (eq? (car part) 'constant)
                     (cons (cadr part) (caddr part))))
              (cdr section)))

(define (section-parts section name)
  (filter (lambda (part) (and (pair? part) (eq? (car part) name))) (cdr section)))

;; ---- the section as closures

;; Sections that were compiled, newest first: ((SECTION RULES FACTS) ...). They are few: one a domain that this process
;; has read, and one more where its cell has cubes of another size.
(define compiled-sections '())

(define (compiled section)
  (or (assoc section compiled-sections)
      (let ((constants (section-constants section)))
        (set! compiled-sections
              (cons (list section
                          (map (lambda (rule)
                                 (list (cadr rule)
                                       (compile-head (cadr rule))
                                       (compile-conditions (cddr rule) constants)))
                               (section-parts section 'rule))
                          (map cadr (section-parts section 'fact)))
                    compiled-sections))
        (car compiled-sections))))

;; A section's number, by which it can be called instead of being handed over with every look.
(define (section-number section)
  (length (member (compiled section) compiled-sections eq?)))

(define (section-called name)
  (if (integer? name)
      (list-ref compiled-sections (- (length compiled-sections) name))
      (compiled name)))

;; ---- facts and patterns

;; World: a box of an association list from predicate name to its facts, and the earlier beliefs as such a list.
(define (facts-of world name)
  (let ((entry (assq name world)))
    (if entry (cdr entry) '())))

;; The facts after those of the same name that are there already, in their order.
(define (add-facts world facts)
  (let loop ((facts facts) (new '()))
    (if (null? facts)
        (fold (lambda (entry world)
                (let ((known (assq (car entry) world)) (added (reverse (cdr entry))))
                  (if known
                      (map (lambda (e) (if (eq? e known) (cons (car e) (append (cdr e) added)) e)) world)
                      (cons (cons (car entry) added) world))))
              world new)
        (let* ((fact (car facts)) (entry (assq (car fact) new)))
          (if entry
              (begin (set-cdr! entry (cons fact (cdr entry))) (loop (cdr facts) new))
              (loop (cdr facts) (cons (list (car fact) fact) new)))))))

;; A procedure of a fact's values and an environment: the environment with what the values bind, or #f. What a pattern's
;; arguments are is looked at once.
(define (compile-arguments arguments)
  (if (null? arguments)
      (lambda (values env) (and (null? values) env))
      (let ((argument (car arguments)) (rest (compile-arguments (cdr arguments))))
        (cond
         ((eq? argument '?)
          (lambda (values env) (and (pair? values) (rest (cdr values) env))))
         ((rule-variable? argument)
          (lambda (values env)
            (and (pair? values)
                 (let ((bound (assq argument env)))
                   (cond ((not bound) (rest (cdr values) (acons argument (car values) env)))
                         ((same? (cdr bound) (car values)) (rest (cdr values) env))
                         (else #f))))))
         (else
          (lambda (values env)
            (and (pair? values) (same? argument (car values)) (rest (cdr values) env))))))))

(define (same? a b)
  (or (eq? a b)
      (if (and (number? a) (number? b)) (= a b) (equal? a b))))

(define (compile-conditions conditions constants)
  (if (null? conditions)
      (lambda (env world was emit) (emit env))
      (let ((first (compile-condition (car conditions) constants))
            (rest (compile-conditions (cdr conditions) constants)))
        (lambda (env world was emit)
          (first env world was (lambda (env) (rest env world was emit)))))))

(define (compile-pattern pattern select)
  (let ((name (car pattern)) (match-arguments (compile-arguments (cdr pattern))))
    (lambda (env world was emit)
      (let try ((facts (facts-of (select world was) name)))
        (and (pair? facts)
             (begin
               (count-try!)
               (or (let ((extended (match-arguments (cdar facts) env)))
                     (and extended (emit extended)))
                   (try (cdr facts)))))))))

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
      (if (= (length parts) 2)
          (let ((first (car parts)) (second (cadr parts)))
            (lambda (env world was)
              (let ((a (first env world was)) (b (second env world was)))
                (and (number? a) (number? b) (procedure a b)))))
          (lambda (env world was)
            (let ((values (map (lambda (part) (part env world was)) parts)))
              (and (every number? values) (apply procedure values)))))))
  (cond
   ((rule-variable? x) (lambda (env world was) (let ((bound (assq x env))) (and bound (cdr bound)))))
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

;; A procedure of an environment: the head with its variables replaced.
(define (compile-head head)
  (let ((arguments (map (lambda (x) (if (rule-variable? x) (cons 'variable x) (cons 'value x))) (cdr head))))
    (lambda (env)
      (cons (car head)
            (map (lambda (x)
                   (let ((bound (and (eq? (car x) 'variable) (assq (cdr x) env))))
                     (if bound (cdr bound) (cdr x))))
                 arguments)))))

;; ---- one look

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
  (let ((known (make-hash-table)) (found '()) (instantiate (cadr rule)))
    ((caddr rule) '() world was
     (lambda (env)
       (let ((fact (instantiate env)))
         (unless (hash-ref known fact)
           (hash-set! known fact #t)
           (set! found (cons fact found))
           (count-fact!))
         #f)))
    (reverse found)))

;; The answer of APPLY, or (fail too-much-work SENTENCE HEAD).
(define (within-bounds head apply)
  (let/ec leave
    (set! give-up
          (lambda (what)
            (leave (list 'fail 'too-much-work
                         (simple-format #f "the rule for ~a ~a" (car head) what)
                         head))))
    (apply)))

;; SECTION is a section or its number.
;;
;; (perceive SECTION MEASURED BELIEVED) -> (ok (FACT ...)), the facts that the rules find, in the order found; or (fail
;; too-much-work SENTENCE HEAD), about the rule that was being followed when the bound was reached.
(define (perceive section measured believed)
  (set! tries-left most-tries)
  (set! facts-left most-facts)
  (let* ((known (section-called section))
         (was (add-facts '() believed)))
    (let loop ((rules (cadr known))
               (world (add-facts '() (append (caddr known) measured)))
               (found '()))
      (if (null? rules)
          (list 'ok found)
          (let ((outcome (within-bounds (caar rules) (lambda () (list 'ok (apply-rule (car rules) world was))))))
            (if (eq? (car outcome) 'fail)
                outcome
                (let ((new (filter (lambda (fact) (not (member fact found))) (cadr outcome))))
                  (loop (cdr rules) (add-facts world new) (append found new)))))))))
