;; PDDL problem files, read against their domain.
;;
;; (interpret DATA DOMAIN), DOMAIN being what (pizarra pddl-domain) answers, answers (errors ...) or
;;   (ok (problem ((OBJECT TYPE) ...) (FACT ...) (((FUNCTION ARGUMENT ...) VALUE) ...) (GOAL ...) (ABSENT-GOAL ...)
;;        METRIC))
;; where METRIC is `cost` when costs are to be minimised, else `none`.
;;
;; (interpret-beside DATA FILE), FILE being the data of a domain file that is wrong, answers the problem's errors as far
;; as the domain can be understood.

(define-module (pizarra pddl-problem)
  #:use-module (srfi srfi-1)
  #:use-module (pizarra forms)
  #:use-module (pizarra pddl)
  #:use-module ((pizarra pddl-domain) #:select (guess check-requirements whole-cost))
  #:export (interpret interpret-beside))

(define most-objects 20000)

(define (interpret data domain)
  (interpreting data
    (lambda (file)
      (let ((problem (defined file 'problem)))
        (and problem (apply read-problem problem (cdr domain)))))))

(define (interpret-beside data file)
  (let* ((domain (guess file))
         (outcome (if domain (interpret data domain) '(ok))))
    (if (eq? (car outcome) 'ok) '(ok ()) outcome)))

(define (read-problem problem domain-name types constants predicates functions operators facts)
  (let* ((found (sections (understood (cddr (node-items problem))) '(:domain :requirements :objects :init :goal :metric)))
         (in (lambda (name) (inside found name)))
         (vocabulary (make-vocabulary types predicates functions '()))
         (objects (read-objects (at-most (in ':objects) most-objects "objects") constants vocabulary))
         (term (ground-term (vocabulary-with vocabulary (append constants objects))))
         (initials (filter-map (lambda (node) (read-initial node vocabulary term)) (in ':init)))
         (goals (read-goal problem found vocabulary term))
         (never-differ (filter-map differs-from-itself goals)))
    (refuse-two-values (in ':init))
    (check-domain problem found domain-name)
    (check-requirements (in ':requirements))
    (list 'problem objects (append (of-kind initials 'fact) never-differ) (of-kind initials 'value)
          (append (literals-of goals 'fact) (filter-map equals-another goals))
          (append (literals-of goals 'not) never-differ)
          (read-metric found))))

;; What is equal, nothing changes. Goals that are true need no mention, and the others are facts of a predicate `=` that
;; no action knows: (= A B), and not (= A A), which holds from the beginning.
(define (equals-another literal)
  (and (eq? (first literal) '=) (not (eq? (second literal) (third literal))) literal))

(define (differs-from-itself literal)
  (and (eq? (first literal) 'differ) (eq? (second literal) (third literal)) (cons '= (cdr literal))))

(define (inside found name)
  (let ((section (section-in found name)))
    (if section (node-rest (node-within section (simple-format #f "in ~a" name))) '())))

(define (of-kind entries kind)
  (filter-map (lambda (entry) (and (eq? (car entry) kind) (second entry))) entries))

(define (check-domain problem found domain-name)
  (let ((section (section-in found ':domain)))
    (if (not section)
        (complain-missing! problem '(:domain) "(:domain ~a) is missing before this" domain-name)
        (let ((name (symbol-at section 1 "the domain's name")))
          (when (and name (not (eq? name domain-name)))
            (complain! section 'wrong-domain "this problem is one of the domain ~a, and the domain file defines ~a"
                       name domain-name))))))

;; A constant may be named again with the same type.
(define (read-objects nodes constants vocabulary)
  (let ((objects (read-declarations nodes "an object" name-node? (lambda (node) (known-type vocabulary node)))))
    (for-each (lambda (node)
                (let ((constant (assq (node-datum node) constants)))
                  (when (and constant (assq (car constant) objects) (not (member constant objects)))
                    (complain! node 'repeated "~a is a constant of type ~a already" (car constant) (second constant)))))
              nodes)
    (remove (lambda (object) (assq (car object) constants)) objects)))

;; (fact FACT), (value ((FUNCTION ARGUMENT ...) VALUE)), or #f for what needs no saying: (not FACT).
(define (read-initial node vocabulary term)
  (case (node-head node)
    ((=)
     (if (= (length (node-rest node)) 2)
         (let ((function (read-cost-term vocabulary (node-ref node 1) term))
               (value (whole-cost (node-ref node 2))))
           (and function value (list 'value (list function value))))
         (complain! node 'malformed "a value is written (= (FUNCTION ARGUMENT ...) NUMBER)")))
    ((not)
     (if (= (length (node-rest node)) 1)
         (begin (read-atom vocabulary (node-ref node 1) term) #f)
         (complain! node 'malformed "a negation is written (not FACT)")))
    (else
     (let ((fact (read-atom vocabulary node term)))
       (and fact (list 'fact fact))))))

;; The same value may be said twice.
(define (refuse-two-values nodes)
  (let ((values-of (make-hash-table)))
    (for-each (lambda (node)
                (when (and (eq? (node-head node) '=) (= (length (node-rest node)) 2))
                  (let* ((function (node-datum (node-ref node 1)))
                         (value (node-datum (node-ref node 2)))
                         (before (hash-ref values-of function)))
                    (if (and before (not (equal? before value)))
                        (complain! node 'repeated "~a has the value ~a already" function before)
                        (hash-set! values-of function value)))))
              nodes)))

(define (read-goal problem found vocabulary term)
  (let* ((section (section-in found ':goal))
         (condition (and section (node-ref (node-within section "in :goal") 1))))
    (cond ((not section) (complain-missing! problem '(:goal) "(:goal ...) is missing before this") '())
          ((not (and condition (= (length (node-items section)) 2) (list? (node-datum condition))))
           (complain! section 'malformed "a goal is written (:goal FACT) or (:goal (and FACT ...))")
           '())
          (else (condition-literals vocabulary condition term)))))

(define (read-metric found)
  (let ((section (section-in found ':metric)))
    (cond ((not section) 'none)
          ((equal? (cdr (node-datum section)) '(minimize (total-cost))) 'cost)
          (else
           (complain! section 'unsupported "the only metric understood is (:metric minimize (total-cost))")))))
