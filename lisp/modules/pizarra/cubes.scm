;; The cubes of a cell or a scenario, and what their size asks of the gripper and the table: see
;; lisp/forms/cell_file.hpp.
;;
;; (cubes-of NODES SIZE), NODES the sections (cube NAME PART ...), answers
;;   ((NAME MARK X Y YAW ON EDGE (FACE FACE-MARK) ...) ...).
;;   No EDGE is above SIZE mm. ON is the cube below, or the empty string for the table. MARK is on each face that has no
;;   FACE-MARK of its own.
;; The others take FOUND, the sections of a world, and answer the default where it says nothing.
;; (cube-size-of FOUND) answers the edge in mm.
;; (openings-of FOUND SIZE) answers how wide the gripper opens, (NARROW NORMAL WIDE).
;; (row-of FOUND) answers the row that cubes are put down in, (X Y-LOW Y-HIGH).

(define-module (pizarra cubes)
  #:use-module (srfi srfi-1)
  #:use-module (pizarra forms)
  #:use-module ((pizarra tags) #:select (dark-families tag-at))
  #:export (cubes-of cube-size-of openings-of row-of))

(define marks '(circle triangle square cross arrow hourglass house star letter-h letter-t letter-y letter-z))
;; Smaller marks are not recognised, and the fingers do not open wider.
(define cube-sizes-mm '(40 64))
(define most-opening-mm 100)
;; As the camera sees an unturned cube.
(define faces '(front back right left top bottom))
(define most-cubes 16)

;; Where a cube on the table can be seen and reached.
(define reach-mm '((250 650) (-350 350)))

(define (cube-name cube) (first cube))
(define (cube-x cube) (third cube))
(define (cube-y cube) (fourth cube))
(define (cube-on cube) (sixth cube))
(define (cube-edge cube) (seventh cube))

(define (on-table? cube) (string? (cube-on cube)))

(define (overlap? a b)
  (and (on-table? a) (on-table? b)
       (< (max (abs (- (cube-x a) (cube-x b))) (abs (- (cube-y a) (cube-y b))))
          (/ (+ (cube-edge a) (cube-edge b)) 2))))

;; Where it stands, (X Y ON), on the cube that (on NAME) names.
(define (place-on node known)
  (let* ((name (symbol-at node 1 "the cube below"))
         (below (and name (assq name known))))
    (cond ((not name) #f)
          ((not below)
           (complain! node 'unknown-object "no cube ~a stands before this one~a" name
                      (suggestion name (map cube-name known))))
          ((any (lambda (cube) (eq? (cube-on cube) name)) known)
           (complain! node 'occupied "another cube stands on ~a already" name))
          (else (list (cube-x below) (cube-y below) name)))))

(define (cube-place node found known)
  (let ((at (section-in found 'at)) (on (section-in found 'on)))
    (cond ((and at on) (complain! on 'repeated "a cube stands either at a place or on a cube"))
          (at (let ((place (numbers-of at reach-mm))) (and place (append place '("")))))
          (on (place-on on known))
          (else (complain! node 'malformed "the cube has no place: (at X Y) or (on CUBE)")))))

;; What (mark ...) or (FACE ...) says: a shape or a tag, or #f.
(define (mark-of node)
  (let ((word (node-ref node 1)))
    (if (and word (memq (node-datum word) dark-families))
        (tag-at node)
        (choice-at node 1 "a mark" (append marks dark-families)))))

;; The marks of faces that have their own, ((FACE MARK) ...).
(define (faces-of found)
  (let* ((node (section-in found 'faces))
         (parts (if node (sections (node-rest (node-within node "in the faces")) faces) '())))
    (filter-map (lambda (face)
                  (let* ((part (section-in parts face)) (mark (and part (mark-of part))))
                    (and mark (list face mark))))
                faces)))

(define (cube-mark node found name)
  (let ((mark (section-in found 'mark)))
    (cond (mark (mark-of mark))
          ((memq name marks) name)
          (else (complain! node 'malformed "the cube ~a needs a (mark ...)~a" name (suggestion #f marks))))))

(define (refuse-collisions cube node known)
  (for-each (lambda (other)
              (when (same-name? (cube-name cube) (cube-name other))
                (complain! node 'repeated "there is a cube ~a already" (cube-name other)))
              (when (overlap? cube other)
                (complain! node 'overlap "~a and ~a stand in one place" (cube-name cube) (cube-name other))))
            known))

;; The cube that NODE describes, which stands after those of KNOWN, or #f.
(define (cube-of node known size)
  (let ((name (and (node-form? node 'cube) (plain-name-at node 1 "the cube's name"))))
    (and name
         (let* ((inside (node-within node (string-append "in cube " (symbol->string name))))
                (found (sections (drop (node-items inside) 2) '(at on yaw mark faces size)))
                (mark (cube-mark inside found name))
                (place (cube-place inside found known))
                (yaw (numbers-in found 'yaw '((-180 180)) '(0)))
                ;; A place for the cell's cubes has room for smaller ones.
                (edge (numbers-in found 'size (list (list (first cube-sizes-mm) size)) (list size))))
           (and mark place
                (let ((cube (cons* name mark (first place) (second place) (first yaw) (third place) (first edge)
                                   (faces-of found))))
                  (refuse-collisions cube node known)
                  cube))))))

(define (cubes-of nodes size)
  (when (> (length nodes) most-cubes)
    (complain! (list-ref nodes most-cubes) 'too-many "a cell has at most ~a cubes" most-cubes))
  (reverse
   (fold (lambda (node known)
           (let ((cube (cube-of node known size)))
             (if cube (cons cube known) known)))
         '() nodes)))

(define (cube-size-of found)
  (first (numbers-in found 'cube-size (list cube-sizes-mm) '(60))))

;; Narrow, normal and wide, in this order.
(define (openings-of found size)
  (let* ((node (section-in found 'openings))
         (range (list (+ size 2) most-opening-mm))
         (openings (numbers-in found 'openings (list range range range)
                               (map (lambda (room) (+ size room)) '(16 24 36)))))
    (when (and node (not (apply <= openings)))
      (complain! node 'malformed "the openings are (openings NARROW NORMAL WIDE), none smaller than the one before"))
    openings))

;; The x of the row that cubes are put down in, and its ends.
(define (row-of found)
  (let* ((node (section-in found 'row))
         (parts (if node (sections (node-rest (node-within node "in the row")) '(x y)) '()))
         (x (numbers-in parts 'x (list (first reach-mm)) '(450)))
         (y (numbers-in parts 'y (list (second reach-mm) (second reach-mm)) '(-200 200))))
    (when (> (first y) (second y))
      (complain! (section-in parts 'y) 'malformed "the row is (y LOW HIGH), its low end first"))
    (append x y)))
