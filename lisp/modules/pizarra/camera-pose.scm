;; Where a cell's camera stands: see lisp/forms/cell_file.hpp for the section, and lisp/forms/camera_pose.hpp for what
;; the numbers mean.
;;
;; (camera-pose-of-section NODE), NODE the section (camera-pose PART ...) of a cell file, answers this form:
;;
;;   ((X Y Z PAN TILT ROLL) (SURE-MM SURE-DEGREES) (MARK-X MARK-Y MARK-Z) FILE AXES)
;;
;; FILE is the empty string where no file is to be preferred. The pose is () in (camera-pose unknown PART ...).
;; AXES, of a pan-tilt unit, are ((X Y Z) (DX DY DZ) (X Y Z) (DX DY DZ)), first pan, or () where nothing is said of them.
;; (interpret DATA), the data of such a file, answers (ok (the same)) or (errors ...).

(define-module (pizarra camera-pose)
  #:use-module (srfi srfi-1)
  #:use-module (pizarra forms)
  #:export (interpret pose-of axes-of camera-pose-of-section usual-guess))

;; How sure a pose is where the file does not say: one that a person measured with a rule.
(define measured-by-hand '(20 2))
;; Of the gripper that the arms come with, in the tool's frame.
(define usual-mark '(30 0 -66))

;; (X Y Z PAN TILT ROLL) of a section's parts.
(define (pose-of parts)
  (append (numbers-in parts 'at '((600 3000) (-2000 2000) (20 2000)) '(1330 0 200))
          (numbers-in parts 'pan '((-60 60)) '(0))
          (numbers-in parts 'tilt '((-60 60)) '(0))
          (numbers-in parts 'roll '((-45 45)) '(0))))

;; The axes in (head ... (pan-axis (at X Y Z) (along X Y Z)) (tilt-axis ...)); NODES are what follows there.
(define (axes-of head nodes)
  (if (null? nodes)
      '()
      (let* ((parts (sections nodes '(pan-axis tilt-axis)))
             (pan (section-in parts 'pan-axis))
             (tilt (section-in parts 'tilt-axis)))
        (unless (and pan tilt)
          (complain-missing! head '() "both axes are needed: (pan-axis (at X Y Z) (along X Y Z)) and (tilt-axis ...)"))
        (if (and pan tilt)
            (append (axis-of pan second "down in the image: its second number")
                    (axis-of tilt first "to the right in the image: its first number"))
            '()))))

(define (axis-of node main main-way)
  (let* ((parts (sections (node-rest node) '(at along)))
         (anywhere '((-500 500) (-500 500) (-500 500)))
         (along (numbers-in parts 'along '((-1 1) (-1 1) (-1 1)) #f)))
    (unless (and (section-in parts 'at) (section-in parts 'along))
      (complain-missing! node '() "an axis needs a point and a direction: (at X Y Z) (along X Y Z)"))
    (when (and along (< (* 2 (main along) (main along)) (apply + (map * along along))))
      (complain! (section-in parts 'along) 'malformed "this axis points mostly ~a is the largest" main-way))
    (when (and along (not (positive? (main along))))
      (complain! (section-in parts 'along) 'malformed "this axis points mostly ~a is positive" main-way))
    (list (numbers-in parts 'at anywhere '(0 0 0)) (or along '(0 0 0)))))

;; Where a cell has no such section: the usual place, as a person would put the cameras there.
(define usual-guess (list (pose-of '()) measured-by-hand usual-mark "" '()))

(define (camera-pose-of-section node known)
  (let* ((nodes (node-rest (node-within node "in the camera's pose")))
         (unknown? (and (pair? nodes) (eq? (node-datum (car nodes)) 'unknown)))
         (parts (if unknown?
                    (sections (cdr nodes) (lset-intersection eq? known '(mark file)))
                    (sections nodes known))))
    (unless (or unknown? (section-in parts 'at))
      (complain-missing! node '(at) "the camera's pose needs its place: (at X Y Z); or it is unknown"))
    (list (if unknown? '() (pose-of parts))
          (numbers-in parts 'sure '((0.01 200) (0.001 20)) measured-by-hand)
          (numbers-in parts 'mark '((-300 300) (-300 300) (-300 300)) usual-mark)
          (text-of-section parts 'file "the file of the pose" "")
          (let ((head (section-in parts 'head)))
            (if head (axes-of head (node-rest head)) '())))))

(define (interpret data)
  (interpreting data
    (lambda (root)
      (let ((section (only-form root 'camera-pose)))
        (and section (camera-pose-of-section section '(at pan tilt roll sure mark head)))))))
