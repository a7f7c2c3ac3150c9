;; Calibration files: see drivers/camera/calibration.hpp for the language.
;;
;; (interpret DATA), the data of a file, answers (errors ...) or
;;   (ok ((WIDTH HEIGHT) LENS LENS (R11 R12 ... R33) (TX TY TZ) (COLUMNS ROWS SQUARE) (PAIRS REPROJECTION EPIPOLAR)))
;; with LENS = (FOCAL-X FOCAL-Y CENTRE-X CENTRE-Y K1 K2 P1 P2 K3), the left one first. Of one camera alone the second
;; LENS, the rotation and the translation are (), and EPIPOLAR is 0.

(define-module (pizarra calibration)
  #:use-module (srfi srfi-1)
  #:use-module (pizarra forms)
  #:export (interpret))

(define pixels '(1 100000))
(define any-number '(-1e6 1e6))
(define sizes '((64 8192) (64 8192)))
(define boards '((2 100) (2 100) (0.1 1000)))
(define (many count range) (make-list count range))

;; The numbers of a section that must be there, or #f.
(define (must-have parent found name ranges)
  (let ((node (section-in found name)))
    (if node
        (numbers-of node ranges)
        (complain-missing! parent (list name) "~a is missing" name))))

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

(define (single-of file)
  (let* ((found (sections (node-rest file) '(size lens board errors)))
         (size (must-have file found 'size sizes))
         (lens (lens-of file found 'lens))
         (board (must-have file found 'board boards))
         (errors (must-have file found 'errors (list '(1 10000) any-number))))
    (list size lens '() '() '() board (and errors (append errors '(0))))))

(define (pair-of file)
  (let* ((found (sections (node-rest file) '(size left right rotation translation board errors)))
         (size (must-have file found 'size sizes))
         (left (lens-of file found 'left))
         (right (lens-of file found 'right))
         (rotation (must-have file found 'rotation (many 9 '(-1 1))))
         (translation (must-have file found 'translation (many 3 any-number)))
         (board (must-have file found 'board boards))
         (errors (must-have file found 'errors (list '(1 10000) any-number any-number))))
    (when rotation (check-rotation found rotation))
    (when (and translation (> (first translation) -1))
      (complain! (section-in found 'translation) 'out-of-range
                 "the right camera must stand to the right of the left one: its first number is below -1"))
    (list size left right rotation translation board errors)))

;; One camera has a lens, a pair a left one and a right one.
(define (single? file)
  (any (lambda (section) (eq? (node-head section) 'lens)) (node-rest file)))

(define (interpret data)
  (interpreting data
    (lambda (root)
      (let ((file (only-form root 'calibration)))
        (and file (if (single? file) (single-of file) (pair-of file)))))))
