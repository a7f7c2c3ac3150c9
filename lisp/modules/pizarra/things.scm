;; Plain things of a cell's world, which bear no marks: (brick NAME (size X Y Z) (at X Y) (yaw DEG)) and
;; (cylinder NAME (size DIAMETER HEIGHT) (at X Y)).
;;
;; (things-of NODES CUBES), NODES these sections and CUBES as (pizarra cubes) answers them, answers
;;   ((NAME brick|cylinder X-SIZE Y-SIZE Z-SIZE X Y YAW) ...). Of a cylinder X-SIZE and Y-SIZE are its diameter.

(define-module (pizarra things)
  #:use-module (srfi srfi-1)
  #:use-module (pizarra forms)
  #:export (things-of))

(define most-things 16)
(define size-mm '(10 150))
(define reach-mm '((-250 650) (-350 350)))  ; the table

;; What stands on the table, seen from above: (X Y YAW HALF-LENGTH HALF-WIDTH).
(define (cube-footprint cube)
  (let ((half (/ (seventh cube) 2)))
    (list (third cube) (fourth cube) (fifth cube) half half)))

(define (footprint thing)
  (list (sixth thing) (seventh thing) (eighth thing) (/ (third thing) 2) (/ (fourth thing) 2)))

(define (degrees->radians degrees) (* degrees (/ (acos -1) 180)))

;; The two directions of its sides, (X Y) each.
(define (sides print)
  (let ((c (cos (degrees->radians (third print)))) (s (sin (degrees->radians (third print)))))
    (list (list c s) (list (- s) c))))

(define (dot a b) (+ (* (first a) (first b)) (* (second a) (second b))))

;; How far it reaches from its middle that way.
(define (reach print way)
  (let ((along (sides print)))
    (+ (* (fourth print) (abs (dot (first along) way))) (* (fifth print) (abs (dot (second along) way))))))

;; Whether two rectangles lie over each other: no side of either parts them.
(define (overlap? a b)
  (let ((apart (list (- (first b) (first a)) (- (second b) (second a)))))
    (every (lambda (way) (< (abs (dot apart way)) (+ (reach a way) (reach b way))))
           (append (sides a) (sides b)))))

(define (size-of node kind found)
  (let ((size (section-in found 'size)))
    (cond ((not size)
           (complain! node 'malformed (if (eq? kind 'brick)
                                          "a brick has a (size X Y Z)"
                                          "a cylinder has a (size DIAMETER HEIGHT)")))
          ((eq? kind 'brick) (numbers-of size (list size-mm size-mm size-mm)))
          (else (let ((numbers (numbers-of size (list size-mm size-mm))))
                  (and numbers (cons (first numbers) numbers)))))))

(define (place-of node found)
  (let ((at (section-in found 'at)))
    (if at
        (numbers-of at reach-mm)
        (complain! node 'malformed "the thing has no place: (at X Y)"))))

(define (refuse-collisions thing node known cubes)
  (for-each (lambda (name)
              (when (same-name? name (first thing))
                (complain! node 'repeated "there is a ~a already" name)))
            (append (map first known) (map first cubes)))
  (for-each (lambda (name print)
              (when (overlap? (footprint thing) print)
                (complain! node 'overlap "~a and ~a stand in one place" name (first thing))))
            (append (map first known) (map first cubes))
            (append (map footprint known) (map cube-footprint cubes))))

(define (thing-of node known cubes)
  (let* ((kind (node-head node))
         (name (plain-name-at node 1 "the thing's name")))
    (and name
         (let* ((inside (node-within node (simple-format #f "in ~a ~a" kind name)))
                (found (sections (drop (node-items inside) 2) (if (eq? kind 'brick) '(size at yaw) '(size at))))
                (size (size-of inside kind found))
                (place (place-of inside found))
                (yaw (numbers-in found 'yaw '((-180 180)) '(0))))
           (and size place
                (let ((thing (append (list name kind) size place yaw)))
                  (refuse-collisions thing node known cubes)
                  thing))))))

(define (things-of nodes cubes)
  (reverse
   (fold (lambda (node known)
           (let ((thing (thing-of node known cubes)))
             (if thing (cons thing known) known)))
         '() (at-most nodes most-things "bricks and cylinders"))))
