(use-modules (pizarra test-checks) (pizarra micro-tasks))

(define primitives '((raise 0) (align 1) (lower 1) (close 0)))
(define aimed '(align lower))
(define targets '((on-top 2) (free-spot 1)))
(define operators '((PICK-UP 1) (STACK 2)))
(define tasks
  '((GRASP (<ob>) (align <ob>) (lower <ob>) (close))
    (PICK-UP (<ob1>) (raise) (GRASP <ob1>) (raise))
    (STACK (<ob1> <ob2>) (align (on-top <ob1> <ob2>)))))

(define (domain tasks) `((domain test (micro-tasks ,@tasks))))

(define (refused . tasks)
  (let ((outcome (interpret (domain tasks) '() primitives aimed targets)))
    (if (eq? (car outcome) 'errors)
        (map (lambda (e) (list (car e) (caddr e))) (cdr outcome))
        outcome)))

(check "a right section" (interpret (domain tasks) operators primitives aimed targets) `(ok (micro-tasks ,@tasks)))
(check "tasks of tasks become primitives" (expand `(micro-tasks ,@tasks) '(PICK-UP circle))
       '((raise) (align circle) (lower circle) (close) (raise)))
(check "parameters inside a target" (expand `(micro-tasks ,@tasks) '(STACK circle square))
       '((align (on-top circle square))))
(check "no such task" (expand `(micro-tasks ,@tasks) '(PUT-DOWN circle)) '())
(check "another number of arguments" (expand `(micro-tasks ,@tasks) '(PICK-UP)) '())

(check "an operator without a task" (map car (cdr (interpret (domain (cddr tasks)) operators primitives aimed targets)))
       '(missing-task))
(check "an operator with another number of parameters"
       (map car (cdr (interpret (domain tasks) '((PICK-UP 2) (STACK 2)) primitives aimed targets))) '(wrong-arity))
(check "no section" (car (cadr (interpret '((domain test)) operators primitives aimed targets))) 'missing-section)

(check "an unknown step" (refused '(A () (rais))) '((unknown-step (0 2 1 2 0))))
(check "the nearest step is told"
       (cadr (cadr (interpret (domain '((A () (rais)))) '() primitives aimed targets)))
       "no primitive and no micro-task before this one is called rais; the nearest is raise")
(check "an operator whose task is written otherwise"
       (cadr (cadr (interpret (domain '((pick-up (<o>) (raise)))) '((PICK-UP 1)) primitives aimed targets)))
       "operator PICK-UP has no micro-task; the nearest is pick-up")
(check "a task is known only after it stands" (refused '(A () (B)) '(B () (raise))) '((unknown-step (0 2 1 2 0))))
(check "a task does not use itself" (refused '(A () (A))) '((unknown-step (0 2 1 2 0))))
(check "an unknown parameter" (refused '(A (<x>) (align (on-top <x> <y>)))) '((unknown-parameter (0 2 1 2 1 2))))
(check "a wrong number of arguments" (refused '(A (<x>) (align))) '((wrong-arity (0 2 1 2))))
(check "defined twice" (refused '(A () (raise)) '(A ())) '((defined-twice (0 2 2 0))))
(check "a primitive cannot be redefined" (refused '(raise ())) '((is-a-primitive (0 2 1 0))))
(check "an unknown target" (refused '(A (<x>) (align (teleport <x>)))) '((unknown-target (0 2 1 2 1 0))))
(check "a target's wrong number of arguments" (refused '(A (<x>) (lower (on-top <x>)))) '((wrong-arity (0 2 1 2 1))))
(check "a target is handed on by a task" (car (interpret (domain '((A (<t>) (align <t>)) (B (<x>) (A (free-spot <x>)))))
                                                         '() primitives aimed targets)) 'ok)
(check "an unknown target is found where it is handed on"
       (refused '(A (<t>) (align <t>)) '(B (<x>) (A (teleport <x>)))) '((unknown-target (0 2 2 2 1 0))))
(check "no target where only an object can stand"
       (refused '(A (<x>) (align (free-spot <x>))) '(B (<x>) (A (free-spot <x>)))) '((wrong-argument (0 2 2 2 1))))
(check "no number, text or nothing as an argument"
       (map car (refused '(A () (align 5)) '(B () (align "x")) '(C () (align ())) '(D () (align (free-spot (x))))))
       '(wrong-argument wrong-argument unknown-target wrong-argument))
(check "odd data" (map car (refused 3 '() '(A) '(A (x)) '(A () 5) '(B () ()))) '(malformed malformed malformed malformed malformed malformed))

(finish-checks)
