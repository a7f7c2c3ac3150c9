;; Calibration files: see drivers/camera/calibration.hpp for the language.
;;
;; (interpret DATA), the data of a file, answers (errors ...) or
;;   (ok ((WIDTH HEIGHT) LENS LENS (R11 R12 ... R33) (TX TY TZ) (COLUMNS ROWS SQUARE) (PAIRS REPROJECTION EPIPOLAR)
;;        (FOCAL CENTRE BASE-LINE)))
;; with LENS = (FOCAL-X FOCAL-Y CENTRE-X CENTRE-Y K1 K2 P1 P2 K3), the left one first, and standard deviations at the
;; end, 0 where they are not told. Of one camera alone the second LENS, the rotation and the translation are (), and
;; EPIPOLAR and BASE-LINE are 0.

(define-module (pizarra calibration)
  #:use-module (srfi srfi-1)
  #:use-module (pizarra forms)
  #:export (interpret))

(define pixels '(1 100000))
(define any-number '(-1e6 1e6))
(define sizes '((64 8192) (64 8192)))
(define boards '((2 100) (2 100) (0.1 1000)))
(define error '(0 10000))
(define (many count range) (make-list count range))

;; The numbers of a section that must be there, or #f.
(define (must-have parent found name ranges)
  (let ((node (section-in found name)))
    (if node
        (numbers-of node ranges)
        (complain-missing! parent (list name) "~a is missing" name))))

;; A lens that sees more than 150 degrees is no pinhole's, and one that sees less than 3 no camera's.
(define least-focal-of-width 1/8)
(define most-focal-of-width 20)
;; By how much a lens may draw in or push out a corner of the image.
(define corner-factors '(1/4 4))

;; How much farther from the centre a lens shows what a pinhole shows in the image's corner.
(define (corner-factor lens size)
  (apply
   (lambda (fx fy cx cy k1 k2 p1 p2 k3)
     (let* ((x (/ (max cx (- (first size) cx)) fx))
            (y (/ (max cy (- (second size) cy)) fy))
            (r2 (+ (* x x) (* y y))))
       (+ 1 (* r2 (+ k1 (* r2 (+ k2 (* r2 k3))))))))
   lens))

;; Values that no lens has would be believed, and used.
(define (check-lens found name lens size)
  (let ((wrong! (lambda (what) (complain! (section-in found name) 'out-of-range what))))
    (apply
     (lambda (fx fy cx cy . distortion)
       (cond ((not (every (lambda (focal) (<= least-focal-of-width (/ focal (first size)) most-focal-of-width))
                          (list fx fy)))
              (wrong! (simple-format #f "the focal lengths are between ~a and ~a px, an eighth and 20 times the width"
                                     (exact->inexact (* least-focal-of-width (first size)))
                                     (* most-focal-of-width (first size)))))
             ((not (<= 1/2 (/ fx fy) 2))
              (wrong! "one focal length is more than twice the other: no camera's pixels are like that"))
             ((not (every (lambda (centre extent) (<= (- extent) centre (* 2 extent))) (list cx cy) size))
              ;; A part of a camera's image may be all that it gives.
              (wrong! "the centre lies farther from the image than the image is large"))
             ((not (<= (first corner-factors) (corner-factor lens size) (second corner-factors)))
              (wrong! "the distortion moves the image's corners more than four times nearer or farther"))))
     lens)))

(define (deviations-of found count)
  (let ((node (section-in found 'deviations)))
    (if node (numbers-of node (many count error)) (many count 0))))

(define (lens-of parent found name)
  (let ((node (section-in found name)))
    (if (not node)
        (complain-missing! parent (list name) "the ~a camera is missing" name)
        (let* ((inside (node-within node (if (eq? name 'lens) "in the lens" (simple-format #f "in the ~a camera" name))))
               (parts (sections (node-rest inside) '(focal centre distortion)))
               (numbers (list (must-have inside parts 'focal (many 2 pixels))
                              (must-have inside parts 'centre (many 2 any-number))
                              (must-have inside parts 'distortion (many 5 any-number)))))
          (and (every pair? numbers) (apply append numbers))))))

;; The rows of a rotation are as long as 1 and at right angles to one another.
(define (check-rotation found rotation)
  (let* ((row (lambda (i) (list-head (list-tail rotation (* 3 i)) 3)))
         (dot (lambda (a b) (apply + (map * (row a) (row b)))))
         (near? (lambda (value wanted) (< (abs (- value wanted)) 1e-3))))
    (unless (and (near? (dot 0 0) 1) (near? (dot 1 1) 1) (near? (dot 2 2) 1)
                 (near? (dot 0 1) 0) (near? (dot 0 2) 0) (near? (dot 1 2) 0))
      (complain! (section-in found 'rotation) 'out-of-range "these nine numbers are no rotation"))))

(define (check-translation found translation)
  (let ((wrong! (lambda (what) (complain! (section-in found 'translation) 'out-of-range what)))
        (aside (abs (first translation))))
    (cond ((> (first translation) -1)
           (wrong! "the right camera must stand to the right of the left one: its first number is below -1"))
          ((or (< aside (abs (second translation))) (< aside (abs (third translation))))
           (wrong! "the right camera must stand beside the left one: its first number is the farthest from 0")))))

(define (single-of file)
  (let* ((found (sections (node-rest file) '(size lens board errors deviations)))
         (size (must-have file found 'size sizes))
         (lens (lens-of file found 'lens))
         (board (must-have file found 'board boards))
         (errors (must-have file found 'errors (list '(1 10000) error)))
         (deviations (deviations-of found 2)))
    (when (and size lens) (check-lens found 'lens lens size))
    (list size lens '() '() '() board (and errors (append errors '(0)))
          (and deviations (append deviations '(0))))))

(define (pair-of file)
  (let* ((found (sections (node-rest file) '(size left right rotation translation board errors deviations)))
         (size (must-have file found 'size sizes))
         (left (lens-of file found 'left))
         (right (lens-of file found 'right))
         (rotation (must-have file found 'rotation (many 9 '(-1 1))))
         (translation (must-have file found 'translation (many 3 any-number)))
         (board (must-have file found 'board boards))
         (errors (must-have file found 'errors (list '(1 10000) error error)))
         (deviations (deviations-of found 3)))
    (when (and size left) (check-lens found 'left left size))
    (when (and size right) (check-lens found 'right right size))
    (when rotation (check-rotation found rotation))
    (when translation (check-translation found translation))
    (list size left right rotation translation board errors deviations)))

;; One camera has a lens, a pair a left one and a right one.
(define (single? file)
  (any (lambda (section) (eq? (node-head section) 'lens)) (node-rest file)))

(define (interpret data)
  (interpreting data
    (lambda (root)
      (let ((file (only-form root 'calibration)))
        (and file (if (single? file) (single-of file) (pair-of file)))))))
