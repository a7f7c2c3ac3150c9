(use-modules (srfi srfi-1) (pizarra agent-program) (pizarra test-checks))

(define limits '(300 32))
(define (load-text words) (load-program 'tester words "a.scm" limits))
(define* (problem-of words #:optional (limits limits))
  (let ((loaded (load-program 'tester words "a.scm" limits))) (and (eq? (first loaded) 'error) (second loaded))))
(define (says? part outcome)
  (and (eq? (first outcome) 'error) (string-contains (third outcome) part) #t))
(define (program-of words) (second (load-text words)))

;; ---- what a file declares

(check "a file's parts and first facts are told"
       (cddr (load-text "(kind belt) (posts (relation b ((s symbol)) (key))) (reads (relation x ((a symbol) (b symbol))))
                         (rule go (x ?a ?b) (tell (b ?a))) (operation (add (n number)) n) (loop tick 50 1) (tell (b up))"))
       '(belt ((relation b ((s symbol)) (key)))
              ((relation x ((a symbol) (b symbol))))
              ((rule go (x ?a ?b) (?a ?b) 0) (operation add (add (n number)) () 0) (loop tick () () 50))
              (((tell (b up))) ())))
(check "a variable of `not` alone is bound to nothing"
       (fourth (first (sixth (load-text "(rule go (and (x ?a) (not (y ?b ?a))) 1)")))) '(?a))

;; ---- what runs do

(define id (program-of "(define n 0)
(rule count (x ?a) (set! n (+ n 1)) (tell (seen ?a ,n)) (retract (old ?a ?)))
(conclude busy (x ?a) (busy ?a) (loud ?a))
(rule asks (go ?a) (for-all (y ?a ?b) (tell (z ?b))) (say \"done \" (length (ask (y ?c)))))
(operation (twice (n number)) (* 2 n))
(operation (bad) (fail 'no \"not now\"))
(rule calls (c) (tell (got ,(call robot (ready)))))
(rule catches (d) (tell (got ,(catch 'board-failure (lambda () (call robot (ready))) (lambda (key symbol sentence) symbol)))))"))
(check "state is kept and variables are put in"
       (begin (run-part id 'count '((?a 7)) 0) (run-part id 'count '((?a 8)) 0))
       '(done (((tell (seen 8 2)) (retract (old 8 ?))) ()) ()))
(check "a conclusion tells its facts" (run-part id 'busy '((?a 1)) 0) '(done (((tell (busy 1)) (tell (loud 1))) ()) ()))
(check "an operation answers" (run-part id 'twice '((n 4)) 0) '(done (() ()) 8))
(check "an operation fails by its own words" (run-part id 'bad '() 0) '(error no "not now"))
(let* ((first-question (run-part id 'asks '((?a 1)) 0))
       (second-question (resume-run id (third first-question) '(ok ((5) (6))) 0)))
  (check "a run asks the board" (list (first first-question) (fourth first-question)) '(asks (ask (y 1 ?b) (?b))))
  (check "and goes on with the answer, what it wants told before the next question told first"
         (list (second second-question) (fourth second-question))
         '((((tell (z 5)) (tell (z 6))) ()) (ask (y ?c) (?c))))
  (check "to its end" (resume-run id (third second-question) '(ok ((1))) 0) '(done (() ("done 1")) ()))
  (check "once" (first (resume-run id (third second-question) '(ok ()) 0)) 'error))
(let ((asked (run-part id 'calls '() 0)))
  (check "a failure of another agent's is the run's" (resume-run id (third asked) '(fail busy "it moves") 0)
         '(error busy "a.scm:7: it moves")))
(let ((asked (run-part id 'catches '() 0)))
  (check "unless it is caught" (second (resume-run id (third asked) '(fail busy "it moves") 0)) '(((tell (got busy))) ())))

;; ---- what a file cannot do

(for-each
 (lambda (words) (check words (problem-of words) 'bad-program))
 '("(system \"true\")" "(open-file \"/etc/passwd\" \"r\")" "(open-input-file \"/etc/passwd\")" "(getenv \"HOME\")"
   "(call-with-output-file \"/tmp/x\" write)" "(delete-file \"x\")" "(primitive-load \"x\")" "(load \"x\")"
   "(socket 2 1 0)" "(primitive-fork)" "(execl \"/bin/true\")" "(use-modules (ice-9 popen))" "(getpid)" "(exit 0)"
   "(@ (guile) system)" "(@@ (guile) system)" "(eval 'x (current-module))" "(resolve-module '(guile))"
   "(module-ref (resolve-interface '(guile)) 'system)" "(dynamic-link)" "(current-output-port)" "(display 1)"
   "#.(system \"true\")" "(sigaction 14 1)" "(setitimer 0 0 0 0 0)" "(sleep 1)" "(call-with-blocked-asyncs car)"
   "(dynamic-wind car car car)" "(define-syntax m (lambda (x) (syntax-case x () ((_ y) (datum->syntax #'y 'system)))))
    (m 1)" "(define-macro (m) 'system) (m)" "(set! if 1)" "(throw 'quit 0)" "(ask (x ?y))"))
(check "what it sets in its copies is set for it alone"
       (let ((loaded (load-text "(set! car cdr) (set! map #f) (tell (x ,(car '(1 2))))")))
         (list (seventh loaded) (first (load-text "(tell (x ,(car '(1 2))))")) (car '(1 2))))
       '((((tell (x (2)))) ()) ok 1))

;; ---- limits

;; A machine that is fast allocates much within the time, too.
(define more-memory '(300 4000))
(check "a loop without end is ended" (problem-of "(let again () (again))" more-memory) 'too-slow)
(check "also where it catches everything"
       (problem-of "(let again () (catch #t (lambda () (let inner () (inner))) (lambda all (again))))"
                   more-memory)
       'too-slow)
(check "memory is limited"
       (second (load-program 'tester "(let again ((all '())) (again (cons (make-vector 1000 0) all)))" "a.scm" '(20000 32)))
       'too-much-memory)
(check "so are the facts of a run"
       (says? "at most so many facts" (load-text "(for-each (lambda (i) (tell (x ,i))) (iota 300))")) #t)
(check "and what is kept from run to run"
       (let ((id (program-of "(define all '()) (rule keep (x) (set! all (cons (make-vector 100000 0) all)))")))
         (let again ((times 200))
           (let ((outcome (run-part id 'keep '() 0)))
             (cond ((eq? (first outcome) 'error) (second outcome))
                   ((= times 0) 'never)
                   (else (again (- times 1)))))))
       'too-much-kept)
(check "an error says where" (says? "a.scm:2:" (load-text "(define n 1)\n(car n)")) #t)
(check "what cannot be read says where" (says? "a.scm:2:5:" (load-text "(define n 1)\n(car")) #t)
(check "names are used once" (says? "two parts" (load-text "(rule a (x) 1) (loop a 100 1)")) #t)
(check "a fact's variables are bound" (says? "no condition binds" (load-text "(rule a (x ?b) (tell (y ?c)))")) #t)

(finish-checks)
