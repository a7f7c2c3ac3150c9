;;; Micro-tasks: how an operation of the plan becomes motions of the arm.
;;;
;;; A micro-tasks section is data, interpreted here and never evaluated. It holds tasks, each made of primitives and of
;;; tasks that stand before it:
;;;
;;;   (micro-tasks
;;;     (GRASP (<ob>) (align <ob>) (lower <ob>) (close))
;;;     (PICK-UP (<ob1>) (open <ob1>) (raise) (GRASP <ob1>) (raise) (check-held <ob1>)))
;;;
;;; Every operator of the domain has a task of its name with as many parameters. An argument is an object's name or
;;; <parameter>; some primitives take a target too, a form such as (on-top <ob1> <ob2>), and so do tasks that hand it on
;;; to them. Which primitives and targets there are, and what they mean, is the coordinator's matter
;;; (agents/coordinator/plan/primitives.hpp).

(define-module (pizarra micro-tasks)
  #:use-module (srfi srfi-1)
  #:use-module (pizarra forms)
  #:export (interpret expand))

(define most-steps 200)

(define (problem symbol sentence path context)
  (list symbol sentence (reverse path) context))

(define (parameter? x)
  (and (symbol? x)
       (let ((name (symbol->string x)))
         (and (> (string-length name) 2) (string-prefix? "<" name) (string-suffix? ">" name)))))

;; (interpret DATA OPERATORS PRIMITIVES AIMED TARGETS), DATA a domain file's, AIMED the names of the primitives that take
;; a target, the others ((name arity) ...), finds and checks its section: (ok SECTION) or (errors ...).
(define (interpret data operators primitives aimed targets)
  (let* ((form-index (list-index (lambda (form) (and (pair? form) (eq? (car form) 'domain))) data))
         (form (and form-index (list-ref data form-index)))
         (index (and form (list-index (lambda (part) (and (pair? part) (eq? (car part) 'micro-tasks))) form))))
    (if (not index)
        (list 'errors (problem 'missing-section "a domain needs a section (micro-tasks ...)"
                               (if form (list form-index) '()) '()))
        (let* ((section (list-ref form index))
               (problems (check-micro-tasks section operators primitives aimed targets)))
          (if (null? problems)
              (list 'ok section)
              (cons 'errors
                    (map (lambda (found)
                           (list (first found) (second found) (cons* form-index index (third found)) (fourth found)))
                         problems)))))))

;; Problems are (symbol sentence path context), paths from the section's own list.
(define (check-micro-tasks section operators primitives aimed targets)
  (if (and (list? section) (pair? section) (eq? (car section) 'micro-tasks))
      (let loop ((tasks (cdr section)) (index 1) (known (known-primitives primitives aimed)) (problems '()))
        (if (null? tasks)
            (append problems (check-operators operators known))
            (let ((found (check-task (car tasks) (list index) known primitives targets)))
              (loop (cdr tasks) (+ index 1)
                    (if (task? (car tasks))
                        (cons (known-task (car tasks) known) known)
                        known)
                    (append problems found)))))
      (list (problem 'malformed "a micro-tasks section is (micro-tasks TASK ...)" '() '()))))

;; The tasks that steps may call: (NAME ARITY KINDS), a kind for each argument: `object`, or `target` where one may stand.
(define (known-primitives primitives aimed)
  (map (lambda (primitive)
         (let ((name (first primitive)) (arity (second primitive)))
           (list name arity (make-list arity (if (memq name aimed) 'target 'object)))))
       primitives))

(define (known-task task known)
  (let ((parameters (cadr task)) (objects (append-map (lambda (step) (objects-of step known)) (cddr task))))
    (list (car task) (length parameters)
          (map (lambda (parameter) (if (memq parameter objects) 'object 'target)) parameters))))

;; The arguments of a step that can only be objects.
(define (objects-of step known)
  (let ((callee (and (list? step) (pair? step) (assq (car step) known))))
    (if (and callee (= (second callee) (length (cdr step))))
        (append-map (lambda (argument kind)
                      (cond ((list? argument) argument)
                            ((eq? kind 'object) (list argument))
                            (else '())))
                    (cdr step) (third callee))
        '())))

(define (check-operators operators known)
  (filter-map
   (lambda (operator)
     (let ((task (assq (car operator) known)))
       (cond
        ((not task)
         (problem 'missing-task
                  (simple-format #f "operator ~a has no micro-task~a" (car operator)
                                 (suggestion (car operator) (map car known)))
                  '() '("in the micro-tasks section")))
        ((not (= (cadr task) (cadr operator)))
         (problem 'wrong-arity
                  (string-append "the micro-task " (symbol->string (car operator))
                                 " and the operator differ in their number of parameters")
                  '() '("in the micro-tasks section")))
        (else #f))))
   operators))

(define (task? x)
  (and (list? x) (>= (length x) 2) (symbol? (car x)) (list? (cadr x)) (every parameter? (cadr x))))

(define (check-task task path known primitives targets)
  (cond
   ((not (task? task))
    (list (problem 'malformed "a micro-task is (NAME (<parameter> ...) STEP ...)" path
                   '("in the micro-tasks section"))))
   ((assq (car task) known)
    (list (problem (if (assq (car task) primitives) 'is-a-primitive 'defined-twice)
                   (string-append (symbol->string (car task)) " is defined already")
                   (cons 0 path) '("in the micro-tasks section"))))
   (else
    (let ((context (list (string-append "in the micro-task " (symbol->string (car task))))))
      (append-map (lambda (step index) (check-step step (cons index path) (cadr task) known targets context))
                  (cddr task)
                  (iota (length (cddr task)) 2))))))

(define (check-step step path parameters known targets context)
  (if (and (list? step) (pair? step) (symbol? (car step)))
      (let ((callee (assq (car step) known)))
        (cond
         ((not callee)
          (list (problem 'unknown-step
                         (simple-format #f "no primitive and no micro-task before this one is called ~a~a" (car step)
                                        (suggestion (car step) (map car known)))
                         (cons 0 path) context)))
         ((not (= (cadr callee) (length (cdr step))))
          (list (problem 'wrong-arity
                         (string-append (symbol->string (car step)) " takes " (number->string (cadr callee))
                                        " arguments")
                         path context)))
         (else
          (append-map (lambda (argument kind index)
                        (check-argument argument kind (cons index path) parameters targets context))
                      (cdr step) (third callee) (iota (length (cdr step)) 1)))))
      (list (problem 'malformed "a step is (NAME ARGUMENT ...)" path context))))

(define (check-argument argument kind path parameters targets context)
  (cond
   ((symbol? argument) (check-name argument path parameters context))
   ((and (list? argument) (eq? kind 'target)) (check-target argument path parameters targets context))
   ((list? argument)
    (list (problem 'wrong-argument "an object's name stands here, no target" path context)))
   (else (list (problem 'wrong-argument "an argument is a name, a <parameter> or a target" path context)))))

(define (check-name name path parameters context)
  (if (and (parameter? name) (not (memq name parameters)))
      (list (problem 'unknown-parameter
                     (string-append (symbol->string name) " is no parameter of this micro-task") path context))
      '()))

(define (check-target target path parameters targets context)
  (let ((known (and (pair? target) (symbol? (car target)) (assq (car target) targets))))
    (cond
     ((not known)
      (list (problem 'unknown-target
                     (string-append "the targets are an object"
                                    (string-concatenate
                                     (map (lambda (form) (string-append ", " (symbol->string (car form)))) targets)))
                     (if (pair? target) (cons 0 path) path) context)))
     ((not (= (cadr known) (length (cdr target))))
      (list (problem 'wrong-arity
                     (string-append (symbol->string (car target)) " takes " (number->string (cadr known)) " arguments")
                     path context)))
     (else
      (append-map (lambda (name index)
                    (if (symbol? name)
                        (check-name name (cons index path) parameters context)
                        (list (problem 'wrong-argument "a target holds names and <parameter>s" (cons index path)
                                       context))))
                  (cdr target) (iota (length (cdr target)) 1))))))

;; (expand SECTION OPERATION) -> the primitives to do, in order; none where the section has no task for it. The section
;; has been checked, so that a task only uses those before it and expansion ends.
(define (expand section operation)
  (let ((task (find (lambda (task) (eq? (car task) (car operation))) (cdr section))))
    (if (and task (= (length (cadr task)) (length (cdr operation))))
        (let ((steps (expand-task section task (cdr operation))))
          (if (<= (length steps) most-steps) steps '()))
        '())))

(define (expand-task section task arguments)
  (let ((bindings (map cons (cadr task) arguments)))
    (append-map (lambda (step)
                  (let* ((step (replace-parameters step bindings))
                         (callee (find (lambda (task) (eq? (car task) (car step))) (cdr section))))
                    (if callee
                        (expand-task section callee (cdr step))
                        (list step))))
                (cddr task))))

(define (replace-parameters x bindings)
  (cond
   ((pair? x) (map (lambda (element) (replace-parameters element bindings)) x))
   ((assq x bindings) => cdr)
   (else x)))
