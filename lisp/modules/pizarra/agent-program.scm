;; Agents that are Scheme files: loads one, and runs its rules, loops and operations. lisp/forms/agent_program.hpp is the
;; other side; (pizarra agent-words) has what a file may say.
;;
;; A file is evaluated in a module of its own that holds pure Scheme and our words: no files, ports, processes, network,
;; modules, `eval`, nor macros that could make names of other modules. It may `set!` what it likes: it has its own copy
;; of every procedure. Each loading and each run is bounded in time and in what it allocates, and the state that it keeps
;; in what it holds.
;;
;;   (load-program AGENT TEXT FILE LIMITS)           -> (ok ID KIND POSTS READS ((SORT NAME HEAD VARIABLES PERIOD) ...) EFFECTS)
;;   (run-part ID NAME ((VARIABLE VALUE) ...) NOW)   -> an outcome
;;   (resume-run ID WAITING ANSWER NOW)              -> an outcome
;;   (abandon-run ID WAITING), (forget-program ID)   -> (ok)
;;
;; with LIMITS = (MILLISECONDS MEGABYTES), EFFECTS = ((STEP ...) ("line said" ...)) and the outcomes
;;   (done EFFECTS VALUE), (asks EFFECTS WAITING QUESTION), (error SYMBOL "sentence").

(define-module (pizarra agent-program)
  #:use-module (srfi srfi-1)
  #:use-module (srfi srfi-9)
  #:use-module (ice-9 sandbox)
  #:use-module (pizarra agent-words)
  #:export (load-program run-part resume-run abandon-run forget-program))

;; ---- the module of a program

(define scheme-names
  (append core-bindings alist-bindings bit-bindings char-bindings error-bindings hash-bindings iteration-bindings
          keyword-bindings list-bindings nil-bindings number-bindings pair-bindings predicate-bindings sort-bindings
          string-bindings symbol-bindings unspecified-bindings vector-bindings
          mutating-alist-bindings mutating-hash-bindings mutating-list-bindings mutating-pair-bindings
          mutating-sort-bindings mutating-string-bindings mutating-vector-bindings
          ;; Macros that cannot make a name out of another's: without datum->syntax.
          '(((guile) set! define-syntax define-syntax-rule let-syntax letrec-syntax syntax-rules)
            ((srfi srfi-1) any every filter filter-map fold fold-right reduce delete delete-duplicates find find-tail
             remove partition count first second third fourth fifth last take drop take-while drop-while list-index
             append-map concatenate)
            ((pizarra agent-words) kind posts reads rule conclude loop operation
             tell retract ask for-all call pause fail say text now me))))

;; The meaning of a macro is found by its variable; procedures are copied, so that `set!` changes none for others.
(define (add-binding! target name variable)
  (if (macro? (variable-ref variable))
      (module-add! target name variable)
      (module-define! target name (variable-ref variable))))

(define (fresh-module)
  (let ((names (make-module)) (program (make-fresh-user-module)))
    (for-each (lambda (set)
                (let ((interface (resolve-interface (car set))))
                  (for-each (lambda (name)
                              (let ((variable (module-variable interface name)))
                                (when (and variable (variable-bound? variable)) (add-binding! names name variable))))
                            (cdr set))))
              scheme-names)
    (purify-module! program)
    (module-use! program names)
    program))

;; ---- limits

(define-record-type <limits>
  (make-limits seconds bytes)
  limits?
  (seconds limit-seconds)
  (bytes limit-bytes))

(define (limits-of milliseconds megabytes)
  (make-limits (/ milliseconds 1000) (* megabytes 1048576)))

(define longest-sentence 600)

(define (shorter text)
  (substring text 0 (min longest-sentence (string-length text))))

;; In one line, without Guile's words for an error whose place it does not know.
(define (sentence-of key values)
  (let* ((whole (call-with-output-string (lambda (port) (print-exception port #f key values))))
         (lines (filter (lambda (line) (not (member line '("" "Syntax error:"))))
                        (map string-trim-both (string-split whole #\newline))))
         (sentence (string-join lines " "))
         (unknown "unknown location: "))
    (shorter (if (string-prefix? unknown sentence) (string-drop sentence (string-length unknown)) sentence))))

(define (failure-of limits key values)
  (cond ((and (eq? key 'limit-exceeded) (equal? (cadr values) "Time limit exceeded"))
         (list 'error 'too-slow (text "it ran longer than " (exact->inexact (limit-seconds limits)) " s")))
        ((eq? key 'limit-exceeded)
         (list 'error 'too-much-memory
               (text "it took more than " (quotient (limit-bytes limits) 1048576) " MB")))
        ((and (eq? key 'board-failure) (= (length values) 2) (symbol? (car values)) (string? (cadr values)))
         (cons 'error values))
        (else (list 'error 'scheme-error (sentence-of key values)))))

;; The answer of THUNK, or (error SYMBOL SENTENCE).
(define (bounded limits thunk)
  (catch #t
    (lambda () (call-with-time-and-allocation-limits (limit-seconds limits) (limit-bytes limits) thunk))
    (lambda (key . values) (failure-of limits key values))))

(define (bytes-held)
  (let ((figures (gc-stats)))
    (- (assq-ref figures 'heap-size) (assq-ref figures 'heap-free-size))))

;; ---- loading

(define-record-type <program>
  (make-program agent limits parts waiting heap)
  program?
  (agent program-agent)
  (limits program-limits)
  (parts program-parts)
  (waiting program-waiting)     ; runs that wait for the board, by number
  (heap program-heap))          ; what the interpreter held before it

(define programs (make-hash-table))
(define last-number 0)
(define (next-number)
  (set! last-number (+ last-number 1))
  last-number)

(define most-waiting 256)

(define (place-of form file)
  (let ((line (and (pair? form) (source-property form 'line))))
    (if line (text file ":" (+ line 1)) file)))

;; A complaint begins with the place where its form begins, unless it says one itself.
(define (complain place file key values)
  (let ((sentence (if (eq? key 'board-failure) (cadr values) (sentence-of key values))))
    (throw 'board-failure 'bad-program
           (if (string-prefix? (string-append file ":") sentence) sentence (text place ": " sentence)))))

(define (read-form port file)
  (catch #t
    (lambda () (read port))
    (lambda (key . values) (complain file file key values))))

(define (evaluate-form form file module)
  (let ((place (place-of form file)))
    (parameterize ((current-place place))
      (catch #t
        (lambda () (eval form module))
        (lambda (key . values) (complain place file key values))))))

(define (evaluate-text words file module)
  (let ((port (open-input-string words)))
    (set-port-filename! port file)
    (let next ()
      (let ((form (read-form port file)))
        (unless (eof-object? form)
          (evaluate-form form file module)
          (next))))))

(define (part-datum part)
  (list (part-sort part) (part-name part) (part-head part) (part-variables part) (part-period part)))

(define (load-program agent words file limits)
  (let* ((limits (apply limits-of limits))
         (heap (begin (gc) (bytes-held)))
         (notes (make-notes #f '() '() '()))
         (run (make-run '() 0 '() 0))
         (outcome (bounded limits
                    (lambda ()
                      (parameterize ((loading notes) (running run) (owner agent))
                        (evaluate-text words file (fresh-module)))
                      '(ok)))))
    (if (eq? (car outcome) 'error)
        outcome
        (let ((id (next-number)) (parts (reverse (notes-parts notes))))
          (hash-set! programs id (make-program agent limits parts (make-hash-table) heap))
          (list 'ok id (or (notes-kind notes) agent) (reverse (notes-posts notes)) (reverse (notes-reads notes))
                (map part-datum parts) (effects-of run))))))

(define (forget-program id)
  (hash-remove! programs id)
  '(ok))

;; ---- running

(define (effects-of run)
  (list (reverse (run-steps run)) (reverse (run-said run))))

;; Only an operation answers.
(define (value-datum part value)
  (if (and (eq? (part-sort part) 'operation) (not (unspecified? value))) (plain-datum value) '()))

;; Runs THUNK until its end or the next question to the board.
(define (outcome-of program part run thunk)
  (let ((outcome
         (bounded (program-limits program)
           (lambda ()
             (parameterize ((running run) (owner (program-agent program)))
               (call-with-prompt board-prompt
                 (lambda ()
                   (let ((value (thunk))) (list 'done (value-datum part value))))
                 (lambda (continuation form) (list 'asks continuation form))))))))
    (case (car outcome)
      ((error) outcome)
      ((done) (or (memory-failure program) (list 'done (effects-of run) (cadr outcome))))
      (else (or (memory-failure program) (wait-with program part run (cadr outcome) (caddr outcome)))))))

(define (wait-with program part run continuation form)
  (if (>= (hash-count (const #t) (program-waiting program)) most-waiting)
      (list 'error 'too-many (text "more than " most-waiting " runs wait for the board"))
      (let ((number (next-number)))
        (hash-set! (program-waiting program) number (cons part continuation))
        (list 'asks (effects-of run) number form))))

;; An error where the program keeps more memory from run to run than it may.
(define (memory-failure program)
  (let ((most (+ (program-heap program) (limit-bytes (program-limits program)))))
    (and (> (bytes-held) most)
         (begin (gc) (> (bytes-held) most))
         (list 'error 'too-much-kept
               (text "what it keeps takes more than " (quotient (limit-bytes (program-limits program)) 1048576)
                     " MB")))))

(define (with-program id use)
  (let ((program (hash-ref programs id)))
    (if program (use program) '(error gone "the program has ended"))))

(define (in-place part outcome)
  (if (and (eq? (car outcome) 'error) (not (eq? (part-sort part) 'operation)))
      (list 'error (cadr outcome) (text (part-place part) ": " (caddr outcome)))
      outcome))

(define (run-part id name bindings now)
  (with-program id
    (lambda (program)
      (let ((part (find (lambda (part) (eq? (part-name part) name)) (program-parts program))))
        (in-place part
          (outcome-of program part (make-run '() 0 '() now)
            (lambda ()
              (apply (part-procedure part)
                     (if (eq? (part-sort part) 'operation)
                         (map cadr bindings)
                         (map (lambda (variable) (cadr (assq variable bindings))) (part-variables part)))))))))))

(define (resume-run id number answer now)
  (with-program id
    (lambda (program)
      (let ((waiting (hash-ref (program-waiting program) number)))
        (hash-remove! (program-waiting program) number)
        (if waiting
            (in-place (car waiting)
              (outcome-of program (car waiting) (make-run '() 0 '() now) (lambda () ((cdr waiting) answer))))
            '(error gone "the run has ended"))))))

(define (abandon-run id number)
  (with-program id
    (lambda (program)
      (hash-remove! (program-waiting program) number)
      '(ok))))
