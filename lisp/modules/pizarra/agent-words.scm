;; The words that an agent's Scheme file is written in; docs/scheme-agents.md says how.
;;
;; The host (agent-program.scm) sets what is loaded or run. A word notes what the file declares, or what a run wants
;; told. A word that needs the board's answer leaves the run through the prompt `board`; the host hands the question out
;; and goes on with the run once the answer is there.
;;
;; In a form for the board, `?x` is the value of the variable where one is in sight, `,(+ n 1)` what that yields, and
;; everything else stands for itself.

(define-module (pizarra agent-words)
  #:use-module (srfi srfi-1)
  #:use-module (srfi srfi-9)
  #:use-module (system syntax)
  #:export (make-notes notes-kind notes-posts notes-reads notes-parts
            make-part part-sort part-name part-head part-variables part-period part-procedure part-place
            loading current-place owner
            make-run run-steps run-said running board-prompt
            plain-datum)
  #:export (kind posts reads rule conclude loop operation
            tell retract ask for-all call pause fail say text now me))

;; ---- what a file declares

(define-record-type <notes>
  (make-notes kind posts reads parts)
  notes?
  (kind notes-kind set-notes-kind!)
  (posts notes-posts set-notes-posts!)     ; newest first, as the next
  (reads notes-reads set-notes-reads!)     ; those that are given whole
  (parts notes-parts set-notes-parts!))

;; SORT is rule, conclude, loop or operation; HEAD the condition, or the operation as a contract offers it.
(define-record-type <part>
  (make-part sort name head variables period procedure place)
  part?
  (sort part-sort)
  (name part-name)
  (head part-head)
  (variables part-variables)
  (period part-period)
  (procedure part-procedure)
  (place part-place))

;; The notes of the file being loaded, or #f, and where its form in hand begins.
(define loading (make-parameter #f))
(define current-place (make-parameter ""))
(define owner (make-parameter #f))

(define most-parts 128)
(define most-relations 64)

(define (noting word)
  (or (loading) (error (string-append "this may stand at the top of the file alone, not where it runs:") word)))

(define (add-part! sort name head variables period procedure)
  (let* ((notes (noting sort))
         (parts (notes-parts notes)))
    (when (any (lambda (part) (eq? (part-name part) name)) parts)
      (error "two parts have the name" name))
    (when (>= (length parts) most-parts)
      (error "an agent has at most so many rules, loops and operations:" most-parts))
    (set-notes-parts! notes (cons (make-part sort name head variables period procedure (current-place)) parts))))

(define (add-loop! name period procedure)
  (unless (and (exact-integer? period) (<= 10 period 86400000))
    (error "a loop's period is 10 to 86400000 milliseconds, not" period))
  (add-part! 'loop name '() '() period procedure))

(define (add-relations! word relations relations-of set-relations!)
  (let* ((notes (noting word))
         (all (append (reverse relations) (relations-of notes))))
    (when (> (length all) most-relations)
      (error (string-append "an agent " (symbol->string word) " at most so many relations:") most-relations))
    (set-relations! notes all)))

;; ---- forms for the board

(define longest-list 10000)
(define deepest 60)

;; The value as the board can hold it.
(define* (plain-datum value #:optional (depth 0))
  (cond ((or (symbol? value) (string? value)) value)
        ((eq? value #t) 'true)
        ((eq? value #f) 'false)
        ((exact-integer? value)
         (if (<= (- (expt 2 63)) value (- (expt 2 63) 1)) value (error "the board holds no number as large as" value)))
        ((real? value)
         (let ((real (exact->inexact value)))
           (if (or (nan? real) (inf? real)) (error "the board holds no number" value) real)))
        ((> depth deepest) (error "lists nest deeper than the board takes"))
        ((and (list? value) (<= (length value) longest-list))
         (map (lambda (item) (plain-datum item (+ depth 1))) value))
        (else (error "the board holds symbols, strings, numbers and lists of them, not" value))))

(eval-when (expand load eval)
  (define (variable? form)
    (and (identifier? form)
         (let ((name (symbol->string (syntax->datum form))))
           (and (> (string-length name) 1) (char=? (string-ref name 0) #\?)))))

  (define (in-sight? identifier)
    (call-with-values (lambda () (syntax-local-binding identifier))
      (lambda (type value) (eq? type 'lexical))))

  ;; An expression for the form; (otherwise VARIABLE) is that for a variable that is not in sight.
  (define (template form otherwise)
    (syntax-case form (unquote unquote-splicing)
      ((unquote expression) #'expression)
      (((unquote-splicing expression) . rest) #`(append expression #,(template #'rest otherwise)))
      ((first . rest) #`(cons #,(template #'first otherwise) #,(template #'rest otherwise)))
      (item
       (cond ((not (variable? #'item)) #''item)
             ((in-sight? #'item) #'item)
             (else (otherwise #'item))))))

  (define (as-it-stands variable) #`(quote #,variable))

  (define (refuse variable)
    (syntax-violation #f "no condition binds this variable" variable))

  ;; The variables that a query binds, each once: those of a `not` stand for anything.
  (define (variables-of query)
    (define (walk form found)
      (syntax-case form (unquote)
        ((unquote expression) found)
        ((first . rest)
         (if (memq (syntax->datum #'first) '(not))
             found
             (walk #'rest (walk #'first found))))
        (item
         (if (and (variable? #'item)
                  (not (in-sight? #'item))
                  (not (memq (syntax->datum #'item) (map syntax->datum found))))
             (cons #'item found)
             found))))
    (reverse (walk query '()))))

(define-syntax board-form
  (lambda (form)
    (syntax-case form ()
      ((_ written) #`(plain-datum #,(template #'written as-it-stands))))))

(define-syntax board-fact
  (lambda (form)
    (syntax-case form ()
      ((_ written) #`(plain-datum #,(template #'written refuse))))))

;; ---- what stands at the top of a file

(define (set-kind! name)
  (set-notes-kind! (noting 'kind) name))

(define-syntax-rule (kind name) (set-kind! 'name))

(define-syntax-rule (posts relation ...)
  (add-relations! 'posts '(relation ...) notes-posts set-notes-posts!))
(define-syntax-rule (reads relation ...)
  (add-relations! 'reads '(relation ...) notes-reads set-notes-reads!))

(define-syntax define-rule-word
  (syntax-rules ()
    ((_ word sort make-body)
     (define-syntax word
       (lambda (form)
         (syntax-case form ()
           ((_ name query first . rest)
            (identifier? #'name)
            (with-syntax (((variable (... ...)) (variables-of #'query)))
              #'(add-part! 'sort 'name (board-form query) '(variable (... ...)) 0
                           (lambda (variable (... ...)) (make-body first . rest)))))
           ((_ . rest)
            (syntax-violation 'word "a rule is (WORD NAME QUERY BODY ...)" form))))))))

(define-syntax-rule (as-body first ...) (begin first ...))

(define-rule-word rule rule as-body)
(define-rule-word conclude conclude tell)

(define-syntax-rule (loop name period body ...)
  (add-loop! 'name period (lambda () body ...)))

(define-syntax-rule (operation (name (argument type) ...) body ...)
  (add-part! 'operation 'name '(name (argument type) ...) '() 0 (lambda (argument ...) body ...)))

;; ---- what a run does

(define-record-type <run>
  (make-run steps step-count said now)
  run?
  (steps run-steps set-run-steps!)     ; newest first
  (step-count run-step-count set-run-step-count!)
  (said run-said set-run-said!)        ; newest first
  (now run-now))

(define running (make-parameter #f))
(define board-prompt (make-prompt-tag 'board))

(define most-steps 256)
(define most-said 20)
(define longest-said 400)

(define (in-run word)
  (or (running) (error "this may not stand here:" word)))

(define (add-step! step)
  (let ((run (in-run (car step))))
    (when (>= (run-step-count run) most-steps)
      (error "a run tells and retracts at most so many facts:" most-steps))
    (set-run-step-count! run (+ 1 (run-step-count run)))
    (set-run-steps! run (cons step (run-steps run)))))

(define-syntax-rule (tell fact ...)
  (begin (add-step! (list 'tell (board-fact fact))) ... (if #f #f)))

(define-syntax-rule (retract pattern ...)
  (begin (add-step! (list 'retract (board-form pattern))) ... (if #f #f)))

;; The host's answer: (ok VALUE) or (fail SYMBOL "sentence").
(define (question . form)
  (when (loading) (error "this may stand where something runs, not at the top of the file:" (car form)))
  (in-run (car form))
  (let ((answer (abort-to-prompt board-prompt form)))
    (if (eq? (car answer) 'ok)
        (cadr answer)
        (throw 'board-failure (cadr answer) (caddr answer)))))

;; The answers, each the values of the query's variables in the order in which they first appear.
(define-syntax ask
  (lambda (form)
    (syntax-case form ()
      ((_ query)
       (with-syntax (((variable ...) (variables-of #'query)))
         #'(question 'ask (board-form query) '(variable ...)))))))

(define-syntax for-all
  (lambda (form)
    (syntax-case form ()
      ((_ query first . rest)
       (with-syntax (((variable ...) (variables-of #'query)))
         #'(for-each (lambda (answer) (apply (lambda (variable ...) first . rest) answer))
                     (question 'ask (board-form query) '(variable ...))))))))

(define most-patience-ms 600000)

(define (call-within agent wanted milliseconds)
  (unless (and (real? milliseconds) (< 0 milliseconds) (<= milliseconds most-patience-ms))
    (error "a call is answered within 1 to 600000 milliseconds, not" milliseconds))
  (question 'call agent wanted (inexact->exact (ceiling milliseconds))))

;; (call AGENT OPERATION) or (call AGENT OPERATION MILLISECONDS): what the agent answers, a list.
(define-syntax call
  (syntax-rules ()
    ((_ agent wanted) (call agent wanted 60000))
    ((_ agent wanted milliseconds) (call-within (board-fact agent) (board-fact wanted) milliseconds))))

(define (pause milliseconds)
  (unless (and (real? milliseconds) (<= 0 milliseconds most-patience-ms))
    (error "a pause is 0 to 600000 milliseconds, not" milliseconds))
  (question 'pause (inexact->exact (ceiling milliseconds)))
  (if #f #f))

;; Of an operation: its answer is this failure.
(define (fail symbol sentence)
  (throw 'board-failure symbol sentence))

(define (text . values)
  (string-concatenate
   (map (lambda (value) (if (string? value) value (simple-format #f "~a" value))) values)))

;; Into the agent's log.
(define (say . values)
  (let ((run (in-run 'say))
        (line (apply text values)))
    (when (< (length (run-said run)) most-said)
      (set-run-said! run (cons (substring line 0 (min longest-said (string-length line))) (run-said run))))))

;; Milliseconds on the board's clock.
(define (now) (run-now (in-run 'now)))

;; The agent's own name.
(define (me) (owner))
