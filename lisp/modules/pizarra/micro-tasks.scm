;;; Micro-tasks: how an operation of the plan becomes motions of the arm.
;;;
;;; A micro-tasks section is data, interpreted here and never evaluated. It holds tasks, each made of primitives and of
;;; tasks that stand before it:
;;;
;;;   (micro-tasks
;;;     (GRASP (<ob>) (align <ob>) (lower <ob>) (close))
;;;     (PICK-UP (<ob1>) (open <ob1>) (raise) (GRASP <ob1>) (raise) (check-held <ob1>)))
;;;
;;; Every operator of the domain has a task of its name with as many parameters. Which primitives there are, and what
;;; they mean, is the coordinator's matter (agents/coordinator/primitives.hpp).

(define-module (pizarra micro-tasks)
  #:use-module (srfi srfi-1)
  #:export (interpret expand))

(define most-steps 200)

(define (problem symbol sentence path context)
  (list symbol sentence (reverse path) context))

(define (parameter? x)
  (and (symbol? x)
       (let ((name (symbol->string x)))
         (and (> (string-length name) 2) (string-prefix? "<" name) (string-suffix? ">" name)))))

;; (interpret DATA OPERATORS PRIMITIVES), DATA a domain file's, the others ((name arity) ...), finds and checks its
;; section: (ok SECTION) or (errors ...).
(define (interpret data operators primitives)
  (let* ((form-index (list-index (lambda (form) (and (pair? form) (eq? (car form) 'domain))) data))
         (form (and form-index (list-ref data form-index)))
         (index (and form (list-index (lambda (part) (and (pair? part) (eq? (car part) 'micro-tasks))) form))))
    (if (not index)
        (list 'errors (problem 'missing-section "a domain needs a section (micro-tasks ...)"
                               (if form (list form-index) '()) '()))
        (let* ((section (list-ref form index))
               (problems (check-micro-tasks section operators primitives)))
          (if (null? problems)
              (list 'ok section)
              (cons 'errors
                    (map (lambda (found)
                           (list (first found) (second found) (cons* form-index index (third found)) (fourth found)))
                         problems)))))))

;; Problems are (symbol sentence path context), paths from the section's own list.
(define (check-micro-tasks section operators primitives)
  (if (and (pair? section) (eq? (car section) 'micro-tasks))
      (let loop ((tasks (cdr section)) (index 1) (known primitives) (problems '()))
        (if (null? tasks)
            (append problems (check-operators operators known))
            (let ((found (check-task (car tasks) (list index) known primitives)))
              (loop (cdr tasks) (+ index 1)
                    (if (task? (car tasks))
                        (cons (list (caar tasks) (length (cadar tasks))) known)
                        known)
                    (append problems found)))))
      (list (problem 'malformed "a micro-tasks section is (micro-tasks TASK ...)" '() '()))))

(define (check-operators operators known)
  (filter-map
   (lambda (operator)
     (let ((task (assq (car operator) known)))
       (cond
        ((not task)
         (problem 'missing-task
                  (string-append "operator " (symbol->string (car operator)) " has no micro-task")
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

(define (check-task task path known primitives)
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
      (append-map (lambda (step index) (check-step step (cons index path) (cadr task) known context))
                  (cddr task)
                  (iota (length (cddr task)) 2))))))

(define (check-step step path parameters known context)
  (if (and (list? step) (pair? step) (symbol? (car step)))
      (let ((callee (assq (car step) known)))
        (cond
         ((not callee)
          (list (problem 'unknown-step
                         (string-append "no primitive and no micro-task before this one is called "
                                        (symbol->string (car step)))
                         (cons 0 path) context)))
         ((not (= (cadr callee) (length (cdr step))))
          (list (problem 'wrong-arity
                         (string-append (symbol->string (car step)) " takes " (number->string (cadr callee))
                                        " arguments")
                         path context)))
         (else (check-arguments (cdr step) path 1 parameters context))))
      (list (problem 'malformed "a step is (NAME ARGUMENT ...)" path context))))

(define (check-arguments arguments path first parameters context)
  (append-map (lambda (x index)
                (cond
                 ((pair? x) (check-arguments x (cons index path) 0 parameters context))
                 ((and (parameter? x) (not (memq x parameters)))
                  (list (problem 'unknown-parameter
                                 (string-append (symbol->string x) " is no parameter of this micro-task")
                                 (cons index path) context)))
                 (else '())))
              arguments
              (iota (length arguments) first)))

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
