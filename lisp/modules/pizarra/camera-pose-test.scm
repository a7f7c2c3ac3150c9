(use-modules (pizarra camera-pose) (pizarra test-checks))

(define (complaint . parts)
  (let ((outcome (interpret (list (cons 'camera-pose parts)))))
    (if (eq? (car outcome) 'errors) (list (length (cdr outcome)) (car (cadr outcome)) (caddr (cadr outcome))) outcome)))

(check "a pose is as sure as one measured by hand, with the usual gripper's mark"
       (interpret '((camera-pose (at 1350 -5 190) (pan 2))))
       '(ok ((1350 -5 190 2 0 0) (20 2) (30 0 -66) "" ())))
(check "all of it may be said"
       (interpret '((camera-pose (at 1350 -5 190) (pan 2) (tilt -1.5) (roll 0.5) (sure 0.4 0.05) (mark 31 0.5 -65))))
       '(ok ((1350 -5 190 2 -1.5 0.5) (0.4 0.05) (31 0.5 -65) "" ())))
(check "where the camera stands may be unknown, and then only the gripper's mark is to be said"
       (list (interpret '((camera-pose unknown (mark 31 0 -65)))) (complaint 'unknown '(at 1350 0 200)))
       '((ok (() (20 2) (31 0 -65) "" ())) (1 unknown-section (0 2))))
(check "a pose needs a place" (complaint '(pan 2)) '(1 malformed (0 2)))
(check "a place has three numbers" (complaint '(at 1350 0)) '(1 malformed (0 1)))
(check "a camera that lies on its side is refused" (complaint '(at 1350 0 200) '(roll 90)) '(1 out-of-range (0 2 1)))
(define (with-axes pan tilt)
  (complaint '(at 1350 0 200) (list 'head pan tilt)))
(check "a camera on a pan-tilt unit may have its axes said"
       (with-axes '(pan-axis (at 5 0 -38) (along 0.02 1 -0.01)) '(tilt-axis (at 0 52 -30) (along 1 0 0)))
       '(ok ((1350 0 200 0 0 0) (20 2) (30 0 -66) "" ((5 0 -38) (0.02 1 -0.01) (0 52 -30) (1 0 0)))))
(check "both axes are needed"
       (complaint '(at 1350 0 200) '(head (pan-axis (at 5 0 -38) (along 0 1 0)))) '(1 malformed (0 2 2)))
(check "an axis needs a point and a direction"
       (with-axes '(pan-axis (at 5 0 -38)) '(tilt-axis (at 0 52 -30) (along 1 0 0))) '(1 malformed (0 2 1 2)))
(check "an axis in another frame is refused"
       (with-axes '(pan-axis (at 5 0 -38) (along 0 0 1)) '(tilt-axis (at 0 52 -30) (along 1 0 0)))
       '(2 malformed (0 2 1 2)))
(check "an axis that turns the other way round is refused"
       (with-axes '(pan-axis (at 5 0 -38) (along 0 1 0)) '(tilt-axis (at 0 52 -30) (along -1 0 0)))
       '(1 malformed (0 2 2 2)))
(check "nothing is perfectly sure" (complaint '(at 1350 0 200) '(sure 0 0)) '(1 out-of-range (0 2 1)))
(check "a file names no other file" (complaint '(at 1350 0 200) '(file "other.scm")) '(1 unknown-section (0 2)))

(finish-checks)
