;; Scenario files: see lisp/forms/scenario_file.hpp for the language.
;;
;; (interpret DATA CUBE-SIZE), the data of a file and the edge of its cell's cubes, answers (errors ...) or
;;   (ok (NAME CELL DOMAIN (cubes CUBE ...)|() (GOAL-FACT ...) (ACTION ...) ((CONDITION ACTION ...) ...)
;;        reached|refused REFUSAL (SEEN ...) (NEVER ...) SECONDS SEED))
;; with DOMAIN and REFUSAL the empty string where they are not given, CUBE as in cell.scm.

(define-module (pizarra scenario)
  #:use-module (srfi srfi-1)
  #:use-module (pizarra forms)
  #:use-module ((pizarra cubes) #:select (cubes-of))
  #:export (interpret))

(define hand-operations
  '((push . 3) (slide . 4) (place . 3) (stack . 2) (hold . 5) (turn . 2) (steal . 1) (remove . 1) (add . 4) (knock . 1)))

;; Whether the items of NODE from its second on are an operation of the hand; complains where not.
(define (hand-operation? node)
  (let* ((operation (symbol-at node 1 "the hand's operation"))
         (arguments (and operation (assq-ref hand-operations operation))))
    (cond ((not operation) #f)
          ((not arguments)
           (complain! node 'unknown-action "the hand cannot ~a~a" operation
                      (suggestion operation (map car hand-operations))))
          ((= (- (length (node-items node)) 2) arguments) #t)
          (else (complain! node 'malformed "(hand ~a ...) takes ~a arguments" operation arguments)))))

;; The same of what makes the gripper's fingers clumsy.
(define (fingers-operation? node)
  (define (ranged ranges)
    (let ((numbers (map node-datum (drop (node-items node) 2))))
      (or (and (= (length numbers) (length ranges))
               (every (lambda (number range) (and (real? number) (<= (first range) number (second range))))
                      numbers ranges))
          (complain! node 'malformed
                     "it is (fingers slip), (fingers slips CHANCE DRAWS SECONDS) or (fingers misplace PART)"))))
  (case (symbol-at node 1 "what the fingers do")
    ((slip) (ranged '()))
    ((slips) (ranged '((0 1) (1 10) (0 600))))
    ((misplace) (ranged '((0 1))))
    ((#f) #f)
    (else (complain! node 'unknown-action "what fingers do is slip, slips or misplace"))))

;; The same of the camera, and of the pan-tilt unit under it, which somebody may knock against.
(define (knock? node operation count form)
  (let ((what (symbol-at node 1 "what happens to it"))
        (numbers (map node-datum (drop (node-items node) (min 2 (length (node-items node)))))))
    (cond ((not what) #f)
          ((not (eq? what operation)) (complain! node 'unknown-action "only ~a is possible here" form))
          ((and (= (length numbers) count) (every (lambda (number) (and (real? number) (<= -200 number 200))) numbers))
           #t)
          (else (complain! node 'malformed "it is ~a" form)))))

(define (action? node)
  (let ((head (and (pair? (node-datum node)) (car (node-datum node)))))
    (case head
      ((hand) (hand-operation? node))
      ((fingers) (fingers-operation? node))
      ((camera) (knock? node 'bump 6 "(camera bump DX DY DZ DPAN DTILT DROLL)"))
      ((head) (knock? node 'nudge 2 "(head nudge DPAN DTILT)"))
      ((wait) (and (numbers-of node '((0 600))) #t))
      ((goal) (fact-forms? (node-rest node)))
      ((kill) (and (symbol-at node 1 "the agent") #t))
      ((restart) (and (symbol-at node 1 "the agent")
                      (or (= (length (node-items node)) 2) (string-at node 2 "the host"))
                      #t))
      ((wire) (and (symbol-at node 1 "the client") (symbol-at node 2 "the role") (symbol-at node 3 "the agent") #t))
      (else
       (complain! node 'unknown-action
                 "an action is one of hand, fingers, camera, head, kill, restart, wire, wait, goal")))))

(define (actions-of nodes)
  (map node-datum (filter action? nodes)))

(define (fact-forms? nodes)
  (every (lambda (node)
           (or (pair? (node-datum node))
               (complain! node 'malformed "a fact is a list (PREDICATE ARGUMENT ...)")))
         nodes))

(define (event-of node)
  (let ((condition (node-ref node 1)))
    (cond ((not (and condition (pair? (node-datum condition))))
           (complain! node 'malformed "an event is (when CONDITION ACTION ...)"))
          (else (cons (node-datum condition) (actions-of (drop (node-items node) 2)))))))

;; (reached "") or (refused SYMBOL).
(define (expectation-of found)
  (let* ((node (section-in found 'expect))
         (words (if node (map node-datum (node-rest node)) '(reached))))
    (cond ((equal? words '(reached)) '(reached ""))
          ((equal? words '(refused)) '(refused ""))
          ((and (= (length words) 2) (eq? (first words) 'refused) (symbol? (second words)))
           (list 'refused (symbol->string (second words))))
          (else
           (complain! node 'malformed "it is (expect reached) or (expect refused SYMBOL)")
           '(reached "")))))

(define (patterns-in found name)
  (append-map (lambda (node)
                (if (fact-forms? (node-rest node)) (map node-datum (node-rest node)) '()))
              (sections-in found name)))

(define (number-in found name range otherwise)
  (let* ((node (section-in found name)) (numbers (and node (numbers-of node (list range)))))
    (if numbers (first numbers) otherwise)))

(define (required found scenario name)
  (or (section-in found name)
      (complain! scenario 'malformed "the scenario has no (~a ...)" name)))

(define (interpret-sections scenario name cube-size)
  (let* ((found (sections (drop (node-items scenario) 2)
                          '(cell domain cubes goal before-goal when expect expect-seen expect-not within seed)
                          '(when expect-seen expect-not)))
         (cubes (section-in found 'cubes))
         (before (section-in found 'before-goal))
         (goal (required found scenario 'goal)))
    (required found scenario 'cell)
    `(,name
      ,(text-of-section found 'cell "the cell's file" "")
      ,(text-of-section found 'domain "the domain's file" "")
      ,(if cubes (cons 'cubes (cubes-of (node-rest cubes) cube-size)) '())
      ,(if (and goal (fact-forms? (node-rest goal))) (map node-datum (node-rest goal)) '())
      ,(if before (actions-of (node-rest before)) '())
      ,(filter-map event-of (sections-in found 'when))
      ,@(expectation-of found)
      ,(patterns-in found 'expect-seen)
      ,(patterns-in found 'expect-not)
      ,(number-in found 'within '(1 3600) 180)
      ,(number-in found 'seed '(0 4294967295) 1))))

(define (interpret data cube-size)
  (interpreting data
    (lambda (root)
      (let* ((scenario (only-form root 'scenario))
             (name (and scenario (string-at scenario 1 "the scenario's name"))))
        (and name
             (interpret-sections (node-within scenario (string-append "in scenario \"" name "\"")) name cube-size))))))
