;;; A look of the eyes, from the thesis' reply to what holds, in one go: the reply is interpreted, what it names is
;;; placed, what the gripper hides is excused, and the domain's rules are followed.
;;;
;;; Points and directions are lists (X Y Z), mm, in the arm's base frame.

(define-module (pizarra looks)
  #:use-module (srfi srfi-1)
  #:use-module (ice-9 match)
  #:use-module ((pizarra vision-replies) #:prefix replies:)
  #:use-module (pizarra perceive)
  #:export (interpret place hidden?))

;; (interpret DATA OF SITUATION SECTION BELIEVED) => (ok (SEEN HIDDEN OUTCOME)), or (errors ...) about the reply.
;;
;; DATA is what is read of the reply (TRACK N ("a" OK (x, y, d)) ...), OF what the look adds to each name:
;; (("a" STATE CONFIDENCE (face DEGREES) ...) ...). SITUATION is (CAMERA HAND REMEMBERED MEASURED):
;;   CAMERA      (FOCAL CX CY BASE-LINE CENTRE ACROSS DOWN FORWARD), px, mm and points
;;   HAND        (MARK OFFSET GRIP HALF-WIDTH BELOW MARK-HALF): from the mark's place to where the mark of a held object
;;               would stand; where that is while the mark is not seen, or (); and the outline that hides what is behind
;;   REMEMBERED  ((NAME PLACE AGE EXCUSABLE) ...), of AGE looks ago; EXCUSABLE 0 where it was hidden for too long
;;   MEASURED    (FACT ...), besides what is seen
;;
;; SEEN is ((NAME X Y Z) ...), (NAME X Y Z DEGREES) of a face; HIDDEN is (NAME ...). OUTCOME is (ok (FACT ...)), what
;; the rules of SECTION find, or (fail ...) as perceive has it.
(define (interpret data of situation section believed)
  (match (replies:interpret data)
    (('ok ('track . tracked))
     (match situation
       ((camera hand remembered measured)
        (list 'ok (perceive-tracked tracked of camera hand remembered measured section believed)))))
    (('ok _) '(errors (malformed "a look's reply is a TRACK form" (0) ())))
    (errors errors)))

(define (perceive-tracked tracked of camera hand remembered measured section believed)
  (let* ((mark (first hand))
         (seen (filter-map
                (match-lambda
                  ((name x y range)
                   (cons name (place camera x y (if (rough? name hand of) (range-by-arm camera hand) range))))
                  (_ #f))
                tracked))
         (grip (grip-place hand (assoc-ref seen mark)))
         (missing (remove (lambda (known) (or (equal? (first known) mark) (assoc (first known) seen))) remembered))
         (hidden (map first (filter (lambda (known) (excused? camera hand grip known)) missing)))
         (facts (append (if (null? grip) '() (list (cons 'grip grip)))
                        (append-map (lambda (one) (if (equal? (car one) mark) '() (list (seen-fact one)))) seen)
                        (append-map (lambda (known) (remembered-facts known (member (first known) hidden)))
                                    missing))))
    (list (map (lambda (one) (append one (face-of (car one) of))) seen)
          hidden
          (perceive section (append measured facts) believed))))

(define (seen-fact one)
  (cons* 'seen (string->symbol (car one)) (cdr one)))

;; One that is hidden is as young as it was.
(define (remembered-facts known hidden?)
  (match known
    ((name at age _)
     (let ((fact (seen-fact (cons name at))))
       (if (and hidden? (= age 1))
           (list fact)
           (list fact (list 'unseen (string->symbol name))))))))

;; (DEGREES), or () where none is told.
(define (face-of name of)
  (match (part-of 'face name of)
    (('face (? number? degrees)) (list degrees))
    (_ '())))

;; A range from one image alone is too rough to measure by. That of the hand's mark the arm knows better.
(define most-spread-mm 5)

(define (rough? name hand of)
  (match (list hand (part-of 'range name of))
    (((mark _ (_ . _) . _) ('range _ (? number? spread))) (and (equal? name mark) (> spread most-spread-mm)))
    (_ #f)))

(define (range-by-arm camera hand)
  (match (list camera hand)
    (((_ _ _ _ centre . _) (_ offset grip . _))
     (let ((mark (map - grip offset)))
       (sqrt (fold (lambda (a b sum) (+ sum (expt (- a b) 2))) 0 mark centre))))))

;; Whoever tells looks may tell other parts, or what is none.
(define (part-of kind name of)
  (let ((entry (find (lambda (each) (and (pair? each) (equal? (car each) name))) of)))
    (and entry (find (lambda (part) (and (pair? part) (eq? (car part) kind))) (cdr entry)))))

(define (grip-place hand mark)
  (match hand
    ((_ offset otherwise . _) (if mark (map + mark offset) otherwise))))

(define (excused? camera hand grip known)
  (match (list hand known)
    (((_ _ _ half-width below mark-half) (_ at _ excusable))
     (and (pair? grip) (= excusable 1)
          (hidden? camera (list half-width below mark-half) grip at)))))

;; ---- geometry

(define (dot a b) (fold (lambda (x y sum) (+ sum (* x y))) 0 a b))

(define (scaled factor a) (map (lambda (x) (* factor x)) a))

;; Where a point stands that the left camera sees at a pixel, RANGE from the middle of the base line. With u, v the
;; slopes of its ray, b the base line and Z the depth, it lies at (Z u - b/2, Z v, Z) from there.
(define (place camera x y range)
  (match camera
    ((focal cx cy base-line centre across down forward)
     (let* ((u (/ (- x cx) focal))
            (v (/ (- y cy) focal))
            (half (/ base-line 2))
            (a (+ 1 (* u u) (* v v)))
            (b (* u half))
            (c (- (* half half) (* range range)))
            (depth (/ (+ b (sqrt (max 0 (- (* b b) (* a c))))) a)))
       (map + centre (scaled (- (* depth u) half) across) (scaled (* depth v) down) (scaled depth forward))))))

;; A point as the left camera sees it: (X-PX Y-PX DEPTH).
(define (sight camera point)
  (match camera
    ((focal cx cy base-line centre across down forward)
     (let* ((from-centre (map - point centre))
            (depth (dot from-centre forward)))
       (list (+ cx (/ (* focal (+ (dot from-centre across) (/ base-line 2))) depth))
             (+ cy (/ (* focal (dot from-centre down)) depth))
             depth)))))

;; Whether a mark at AT stands behind the gripper, whose OUTLINE is (HALF-WIDTH BELOW MARK-HALF) around GRIP. What is
;; held stands in the gripper's own plane.
(define (hidden? camera outline grip at)
  (match (list outline (sight camera grip) (sight camera at))
    (((half-width below mark-half) (grip-x grip-y grip-depth) (x y depth))
     (let ((px-per-mm (/ (first camera) grip-depth)))
       (and (>= depth (- grip-depth mark-half))
            (< (abs (- x grip-x)) (* (+ half-width mark-half) px-per-mm))
            (< (- y grip-y) (* (+ below mark-half) px-per-mm)))))))
