;;; Scenario files: see lisp/scenario.hpp for the language.
;;;
;;; (interpret-scenario DATA), the data of a file, answers
;;;   (scenario NAME CELL DOMAIN (cubes CUBE ...)|() (GOAL-FACT ...) (ACTION ...) ((CONDITION ACTION ...) ...)
;;;             reached|refused REFUSAL (SEEN ...) (NEVER ...) SECONDS SEED)
;;; with DOMAIN and REFUSAL the empty string where not given; or (errors ...).

(define-module (pizarra scenario)
  #:use-module (srfi srfi-1)
  #:use-module (pizarra sections)
  #:use-module (pizarra cell)
  #:export (interpret-scenario))

;; What can be done, and how many arguments each takes.
(define actions '((kill . 1) (restart . 1) (wait . 1)))
(define hand-operations '((push . 3) (place . 3) (stack . 2) (steal . 1) (remove . 1) (add . 4) (knock . 1)))

(define (counted? form allowed)
  (let ((count (assq (car form) allowed)))
    (and count (= (length (cdr form)) (cdr count)))))

(define (action? form)
  (and (pair? form) (symbol? (car form))
       (case (car form)
         ((hand) (and (pair? (cdr form)) (counted? (cdr form) hand-operations)))
         ((wait) (and (counted? form actions) (real? (cadr form)) (<= 0 (cadr form) 600)))
         ((goal) (and (pair? (cdr form)) (every pair? (cdr form))))
         ((kill restart) (and (counted? form actions) (symbol? (cadr form))))
         (else #f))))

(define (interpret-actions forms path first-index)
  (filter-map
   (lambda (form index)
     (if (action? form)
         form
         (begin
           (problem! 'unknown-action
                     (string-append "an action is (hand OPERATION ARGUMENT ...) with one of "
                                    (names->string (map car hand-operations))
                                    ", or (kill AGENT), (restart AGENT), (wait SECONDS), (goal FACT ...)")
                     (append path (list index)))
           #f)))
   forms (iota (length forms) first-index)))

(define (interpret-when found)
  (let ((form (section-form found)) (path (section-path found)))
    (if (and (>= (length form) 3) (pair? (cadr form)))
        (cons (cadr form) (interpret-actions (cddr form) path 2))
        (begin
          (problem! 'malformed "give (when CONDITION ACTION ...)" path)
          #f))))

(define (interpret-expect form path)
  (let* ((expect (section form path 'expect)) (words (if expect (cdr (section-form expect)) '(reached))))
    (cond ((equal? words '(reached)) (list 'reached ""))
          ((and (pair? words) (eq? (car words) 'refused) (null? (cdr words))) (list 'refused ""))
          ((and (= (length words) 2) (eq? (car words) 'refused) (symbol? (cadr words)))
           (list 'refused (symbol->string (cadr words))))
          (else
           (problem! 'malformed "expect is (expect reached) or (expect refused SYMBOL)" (section-path expect))
           '(reached "")))))

(define (patterns form path name)
  (append-map (lambda (found) (cdr (section-form found))) (sections form path name)))

(define (interpret-number form path name otherwise range)
  (let* ((found (section form path name)) (values (and found (section-numbers found 1 (list range)))))
    (if values (first values) otherwise)))

(define (interpret-scenario-cubes form path)
  (let ((cubes (section form path 'cubes)))
    (if (not cubes)
        '()
        (let* ((forms (cdr (section-form cubes))) (where (section-path cubes)))
          (cons 'cubes
                (interpret-cubes
                 (map (lambda (cube index) (cons cube (append where (list index))))
                      forms (iota (length forms) 1))))))))

(define (interpret-one form path)
  (check-sections form path 2
                  '(cell domain cubes goal before-goal when expect expect-seen expect-not within seed))
  (let ((name (form-string form path))
        (cell (section form path 'cell))
        (domain (section form path 'domain))
        (goal (section form path 'goal))
        (before (section form path 'before-goal)))
    (unless cell (problem! 'missing "the scenario has no (cell \"FILE\")" path))
    (unless goal (problem! 'missing "the scenario has no (goal FACT ...)" path))
    `(scenario ,(or name "")
               ,(or (and cell (section-string cell)) "")
               ,(or (and domain (section-string domain)) "")
               ,(interpret-scenario-cubes form path)
               ,(if goal (cdr (section-form goal)) '())
               ,(if before (interpret-actions (cdr (section-form before)) (section-path before) 1) '())
               ,(filter-map interpret-when (sections form path 'when))
               ,@(interpret-expect form path)
               ,(patterns form path 'expect-seen)
               ,(patterns form path 'expect-not)
               ,(interpret-number form path 'within 180 '(1 3600))
               ,(interpret-number form path 'seed 1 '(0 4294967295)))))

(define (interpret-scenario data)
  (with-problems
   (lambda ()
     (only-form data 'scenario interpret-one))))
