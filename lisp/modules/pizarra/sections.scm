;;; Files made of sections: (cell NAME (world ...) (arm ...)), whose every mistake is told at its place.
;;;
;;;   (with-problems
;;;    (lambda ()
;;;      (only-form data 'cell
;;;                 (lambda (form path)
;;;                   (check-sections form path 2 '(world arm))      ; 2: after the head and the name
;;;                   (let ((arm (section form path 'arm)))
;;;                     (and arm (section-choice arm '(crs-f3))))))))
;;;
;;; answers what the procedure answers, or (errors (symbol "sentence" (INDEX ...) (CONTEXT ...)) ...) when problem! was
;;; called meanwhile. A found section is (FORM . PATH), its path the indices that lead to it in the file's data.

(define-module (pizarra sections)
  #:use-module (srfi srfi-1)
  #:export (with-problems problem! only-form check-sections section sections section-form section-path
            section-numbers section-name section-choice section-string form-name form-string names->string))

;; Newest first, while with-problems runs; one file is interpreted at a time.
(define problems '())

(define (problem! symbol sentence path)
  (set! problems (cons (list symbol sentence path '()) problems)))

(define (with-problems thunk)
  (set! problems '())
  (let ((answer (thunk)))
    (if (null? problems) answer (cons 'errors (reverse problems)))))

(define (names->string names)
  (string-join (map symbol->string names) ", "))

;; DATA, a file's data, must be exactly one (HEAD ...); INTERPRET gets it with its path.
(define (only-form data head interpret)
  (cond ((null? data)
         (problem! 'missing (string-append "the file is empty: a (" (symbol->string head) " ...) was expected") '()))
        ((not (headed? (car data) head))
         (problem! 'malformed (string-append "a (" (symbol->string head) " ...) was expected") '(0)))
        ((pair? (cdr data)) (problem! 'malformed "one form a file: this is the second" '(1)))
        (else (interpret (car data) '(0)))))

(define (headed? form head)
  (and (pair? form) (eq? (car form) head)))

;; Everything from START on must be a section of an allowed name.
(define (check-sections form path start allowed)
  (for-each
   (lambda (item index)
     (unless (and (pair? item) (memq (car item) allowed))
       (problem! 'unknown-section
                 (string-append "a section here is one of " (names->string allowed))
                 (append path (list index)))))
   (if (> (length form) start) (drop form start) '())
   (iota (max 0 (- (length form) start)) start)))

(define section-form car)
(define section-path cdr)

(define (sections form path name)
  (filter-map (lambda (item index) (and (headed? item name) (cons item (append path (list index)))))
              form (iota (length form))))

;; The section of that name or #f; a second one is a problem.
(define (section form path name)
  (let ((found (sections form path name)))
    (cond ((null? found) #f)
          ((null? (cdr found)) (car found))
          (else
           (problem! 'twice (string-append "a second (" (symbol->string name) " ...)") (section-path (second found)))
           (car found)))))

;; COUNT numbers, each within its (LOW HIGH) of RANGES; or #f and a problem.
(define (section-numbers found count ranges)
  (let ((values (cdr (section-form found))))
    (cond ((not (and (= (length values) count) (every real? values)))
           (problem! 'malformed (string-append "takes " (number->string count)
                                               (if (= count 1) " number" " numbers"))
                     (section-path found))
           #f)
          (else
           (for-each
            (lambda (value range index)
              (unless (<= (first range) value (second range))
                (problem! 'out-of-range
                          (string-append "must lie within " (number->string (first range)) " and "
                                         (number->string (second range)))
                          (append (section-path found) (list index)))))
            values ranges (iota count 1))
           values))))

(define (section-one found fits? sentence)
  (let ((values (cdr (section-form found))))
    (if (and (= (length values) 1) (fits? (car values)))
        (car values)
        (begin (problem! 'malformed sentence (section-path found)) #f))))

(define (section-name found)
  (section-one found symbol? "takes one name"))

(define (section-string found)
  (section-one found string? "takes one text in double quotes"))

(define (section-choice found choices)
  (section-one found (lambda (value) (memq value choices))
               (string-append "takes one of " (names->string choices))))

;; Letters, digits and dashes, a letter first: what may name a thing, a file and a fact's argument alike.
(define (plain-name? text extra)
  (and (not (string-null? text)) (<= (string-length text) 64)
       (char-alphabetic? (string-ref text 0))
       (string-every (lambda (c) (or (char-alphabetic? c) (char-numeric? c) (memv c extra))) text)))

;; The name after a form's head; or #f and a problem.
(define (form-name form path)
  (if (and (>= (length form) 2) (symbol? (second form)) (plain-name? (symbol->string (second form)) '(#\-)))
      (second form)
      (begin
        (problem! 'malformed
                  (string-append "(" (symbol->string (car form)) " NAME ...): a name of letters, digits and dashes")
                  path)
        #f)))

;; The text after a form's head; or #f and a problem.
(define (form-string form path)
  (if (and (>= (length form) 2) (string? (second form)))
      (second form)
      (begin
        (problem! 'malformed (string-append "(" (symbol->string (car form)) " \"TEXT\" ...): a text in double quotes")
                  path)
        #f)))
