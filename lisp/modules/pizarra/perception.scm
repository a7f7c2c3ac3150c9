;;; Perception rules: what is measured becomes the predicates of a domain.
;;;
;;; A perception section is data, interpreted and never evaluated:
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
;;;   (was FACT)                  it was believed before: for hysteresis; its variables have their values already
;;;
;;; An expression E is a number, a constant, a ?variable, (+ E ...), (- E E), (* E ...), (abs E), (min E ...),
;;; (max E ...), or (if CONDITION E E).
;;;
;;; Here a section is checked; (pizarra perceive) follows its rules.

(define-module (pizarra perception)
  #:use-module (srfi srfi-1)
  #:use-module (pizarra forms)
  #:use-module (pizarra perceive)
  #:export (interpret))

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

(define (perception-data section)
  (let ((sees (section-parts section 'sees)))
    (list (if (null? sees) '(sees OBJECT) (car sees))
          (cons 'constants (map cdr (section-parts section 'constant)))
          (cons 'facts (map cadr (section-parts section 'fact))))))

;; ---- checking: a list of (symbol sentence path context), paths from the section's own list ----

;; What a rule may ask for, ((NAME ARITY) ...): what every look measures, places (which another file may add), predicates,
;; the section's facts, and what rules find.
(define measured '((seen 4) (unseen 1) (gripper 1) (grip 3) (edge 2) (spot 3)))
(define askable (make-parameter '()))

(define (found-by section)
  (filter-map (lambda (part)
                (and (list? part) (pair? part) (memq (car part) '(fact rule)) (pair? (cdr part)) (pattern? (cadr part))
                     (list (caadr part) (length (cdadr part)))))
              (cdr section)))

(define (check-perception section predicates)
  (if (and (pair? section) (eq? (car section) 'perception))
      (let ((constants (section-constants section)))
        (parameterize ((askable (append measured predicates (found-by section))))
          (append-map (lambda (part index) (check-part part (list index) constants predicates))
                      (cdr section)
                      (iota (length (cdr section)) 1))))
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
       (if (and (= (length part) 2) (pattern? (cadr part)) (not (any rule-variable? (cadr part))))
           '()
           (wrong "a fact is (fact (NAME VALUE ...)) without variables")))
      ((rule) (check-rule part path constants predicates))
      (else (wrong "a part is sees, constant, fact or rule"))))))

(define (pattern? x)
  (and (list? x) (pair? x) (symbol? (car x)) (not (rule-variable? (car x))) (every atom? (cdr x))))

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
                                     (if (and (rule-variable? argument) (not (memq argument bound)))
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
      (append (filter (lambda (x) (and (rule-variable? x) (not (eq? x '?)))) (cdr condition)) bound)
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
        (append (check-pattern (cadr condition) (cons 1 path) context)
                (check-known (cdadr condition) (cons 1 path) bound context))
        (wrong "was is (was FACT)")))
   ((pattern? condition) (check-pattern condition path context))
   (else (wrong "a pattern holds names, numbers, strings and ?variables only"))))

(define (check-pattern pattern path context)
  (let* ((name (car pattern)) (count (length (cdr pattern)))
         (arities (filter-map (lambda (known) (and (eq? (first known) name) (second known))) (askable))))
    (cond
     ((memv count arities) '())
     ((null? arities)
      (list (problem 'unknown-fact
                     (simple-format #f "nothing that could be found is called ~a~a" name
                                    (suggestion name (delete-duplicates (map first (askable)))))
                     (cons 0 path) context)))
     (else
      (list (problem 'wrong-arity (simple-format #f "~a has ~a arguments, not ~a" name (car arities) count)
                     path context))))))

;; A belief of before gives no values: a variable that has none would stand for anything, and take another one later.
(define (check-known arguments path bound context)
  (append-map (lambda (x index)
                (if (and (rule-variable? x) (not (eq? x '?)) (not (memq x bound)))
                    (list (problem 'unbound-variable
                                   (string-append "no condition before gives " (symbol->string x) " a value")
                                   (cons index path) context))
                    '()))
              arguments (iota (length arguments) 1)))

(define (check-expression x path bound constants context names?)
  (define (wrong symbol sentence) (list (problem symbol sentence path context)))
  (cond
   ((number? x) '())
   ((rule-variable? x)
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
