(use-modules (pizarra camera-pose) (pizarra checks))

(define (complaint . parts)
  (let ((outcome (interpret (list (cons 'camera-pose parts)))))
    (if (eq? (car outcome) 'errors) (list (length (cdr outcome)) (car (cadr outcome)) (caddr (cadr outcome))) outcome)))

(check "a pose is as sure as one measured by hand, with the usual gripper's mark"
       (interpret '((camera-pose (at 1350 -5 190) (pan 2))))
       '(ok ((1350 -5 190 2 0 0) (20 2) (30 0 -66) "")))
(check "all of it may be said"
       (interpret '((camera-pose (at 1350 -5 190) (pan 2) (tilt -1.5) (roll 0.5) (sure 0.4 0.05) (mark 31 0.5 -65))))
       '(ok ((1350 -5 190 2 -1.5 0.5) (0.4 0.05) (31 0.5 -65) "")))
(check "where the camera stands may be unknown, and then only the gripper's mark is to be said"
       (list (interpret '((camera-pose unknown (mark 31 0 -65)))) (complaint 'unknown '(at 1350 0 200)))
       '((ok (() (20 2) (31 0 -65) "")) (1 unknown-section (0 2))))
(check "a pose needs a place" (complaint '(pan 2)) '(1 malformed (0 2)))
(check "a place has three numbers" (complaint '(at 1350 0)) '(1 malformed (0 1)))
(check "a camera that lies on its side is refused" (complaint '(at 1350 0 200) '(roll 90)) '(1 out-of-range (0 2 1)))
(check "nothing is perfectly sure" (complaint '(at 1350 0 200) '(sure 0 0)) '(1 out-of-range (0 2 1)))
(check "a file names no other file" (complaint '(at 1350 0 200) '(file "other.scm")) '(1 unknown-section (0 2)))

(finish-checks)
