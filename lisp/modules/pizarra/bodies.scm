;; Bodies in cell files, of which several faces bear tags: (bodies (NAME (MARK (X Y Z) (RX RY RZ)) ...) ...), mm and degrees.
;;
;; (bodies-of FOUND TAGGED) answers ((NAME ("MARK" (X Y Z) (RX RY RZ)) ...) ...), or ().
;;   FOUND are the sections of a cell. TAGGED are its objects with tags, as (pizarra tags) answers them.
;;   A MARK is one of these objects, and stands on one body.

(define-module (pizarra bodies)
  #:use-module (srfi srfi-1)
  #:use-module (pizarra forms)
  #:use-module ((pizarra tags) #:select (refuse-more))
  #:export (bodies-of))

;; As many as the eyes take.
(define most-bodies 8)
(define most-marks 12)
(define farthest-mm '(-2000 2000))
(define turn-deg '(-360 360))

;; Three numbers in the list at INDEX, or #f.
(define (three-at node index what range)
  (let* ((three (node-ref node index))
         (numbers (if three (node-items three) '())))
    (cond ((not three) (complain! node 'malformed "~a is missing: a mark is (MARK (X Y Z) (RX RY RZ))" what))
          ((not (and (= (length numbers) 3) (every (lambda (number) (real? (node-datum number))) numbers)))
           (complain! three 'malformed "~a is three numbers" what))
          ((find (lambda (number) (not (<= (first range) (node-datum number) (second range)))) numbers)
           => (lambda (number)
                (complain! number 'out-of-range "this must lie between ~a and ~a" (first range) (second range))))
          (else (node-datum three)))))

(define (mark-on-body node tagged)
  (let* ((name (plain-name-at node 0 "the mark's name"))
         (place (and name (three-at node 1 "its place" farthest-mm)))
         (turn (and place (three-at node 2 "its turn" turn-deg))))
    (refuse-more node 3 "(MARK (X Y Z) (RX RY RZ))")
    (cond ((not turn) #f)
          ((find (lambda (object) (same-name? name (first object))) tagged)
           => (lambda (object) (list (symbol->string (first object)) place turn)))
          (else
           (complain! (node-ref node 0) 'unknown-object "(tagged ...) names no ~a~a" name
                      (suggestion name (map first tagged)))))))

(define (body-of node tagged)
  (let ((name (plain-name-at node 0 "the body's name")))
    (cond ((not name) #f)
          ((find (lambda (object) (same-name? name (first object))) tagged)
           (complain! (node-ref node 0) 'repeated "an object with a tag is called ~a already" name))
          ((null? (node-rest node))
           (complain! node 'malformed "a body is (NAME (MARK (X Y Z) (RX RY RZ)) ...)"))
          (else
           (cons name
                 (filter-map (lambda (mark) (mark-on-body mark tagged))
                             (at-most (node-rest (node-within node (string-append "in body " (symbol->string name))))
                                      most-marks "marks of a body")))))))

(define (lowered-head node)
  (and=> (node-head node) (lambda (name) (string-downcase (symbol->string name)))))

(define (bodies-of found tagged)
  (let* ((node (section-in found 'bodies))
         (given (if node (node-rest (node-within node "in the bodies")) '())))
    (when (and node (null? given))
      (complain! node 'malformed "bodies are (bodies (NAME (MARK (X Y Z) (RX RY RZ)) ...) ...)"))
    (refuse-repeated given lowered-head "a body")
    (refuse-repeated (append-map (lambda (body) (if (pair? (node-items body)) (node-rest body) '()))
                                 (filter (lambda (body) (list? (node-datum body))) given))
                     lowered-head "a mark of a body")
    (filter-map (lambda (body) (body-of body tagged)) (at-most given most-bodies "bodies"))))
