;; Plain English for an arm and its cell: see lisp/forms/sentence.hpp.
;;
;; (interpret WORDS), symbols and numbers, answers (errors ...) or (ok (AGENT OPERATION)): AGENT `robot` and one of its
;; operations, or `coordinator` and (goal FACT).

(define-module (pizarra sentences)
  #:use-module (srfi srfi-1)
  #:use-module (pizarra forms)
  #:export (interpret))

;; Words that say nothing here.
(define fillers '(the a an please now then to by block cube arm robot it at of its hand))

(define length-units
  '((mm . 1) (millimetre . 1) (millimetres . 1) (millimeter . 1) (millimeters . 1)
    (cm . 10) (centimetre . 10) (centimetres . 10) (centimeter . 10) (centimeters . 10)
    (m . 1000) (metre . 1000) (metres . 1000) (meter . 1000) (meters . 1000)
    (inch . 25.4) (inches . 25.4)))
(define angle-units '((degrees . 1) (degree . 1) (deg . 1)))
(define part-units '((percent . 1)))

(define numbers
  '((one . 1) (two . 2) (three . 3) (four . 4) (five . 5) (six . 6) (seven . 7) (eight . 8) (nine . 9) (ten . 10)
    (twelve . 12) (fifteen . 15) (twenty . 20) (thirty . 30) (forty . 40) (fifty . 50) (ninety . 90) (hundred . 100)
    (half . 0.5)))

;; PATTERN and what it means. A symbol stands for itself, a list for any of its words, <...> for what it says; in the
;; meaning they stand for what was found, in their order: the first is 1.
(define sentences
  '(((move (left right) <length>) (robot (move-h 1 2)))
    ((move (up down) <length>) (robot (move-v 1 2)))
    ((move (forward forwards ahead out) <length>) (robot (extend keep-height 2)))
    ((move (back backward backwards in) <length>) (robot (retract 2)))
    ((turn (left right) <angle>) (robot (turn 1 2)))
    ((turn (wrist fingers) (left right) <angle>) (robot (turn-wrist 2 3)))
    ((tilt (up down) <angle>) (robot (turn-ef 1 2)))
    ((open gripper <length>) (robot (gripper 1)))
    ((open gripper) (robot (gripper 84)))
    ((close gripper) (robot (gripper 0)))
    ((go home) (robot (home)))
    ((get ready) (robot (ready)))
    ((set speed <part>) (robot (speed 1)))
    ((remember this as <name>) (robot (learn 1)))
    ((go <name>) (robot (goto 1)))
    ((stop) (robot (finish stop)))
    ((where are you) (robot (monitor)))
    ((pick up <name>) (coordinator (goal (holding 1))))
    (((take grasp) <name>) (coordinator (goal (holding 2))))
    ((put down <name>) (coordinator (goal (on-table 1))))
    ((put <name> down) (coordinator (goal (on-table 1))))
    ((put <name> on table) (coordinator (goal (on-table 1))))
    (((put stack) <name> on <name>) (coordinator (goal (on 2 3))))))

(define known-words
  (delete-duplicates
   (append-map (lambda (sentence)
                 (append-map (lambda (part) (cond ((pair? part) part)
                                                  ((memq part '(<length> <angle> <part> <name>)) '())
                                                  (else (list part))))
                             (first sentence)))
               sentences)))

(define (number-of word)
  (if (number? word) word (assq-ref numbers word)))

;; A number with its unit at the head of WORDS: (VALUE . REST), or #f.
(define (measured words units)
  (let ((number (and (pair? words) (number-of (car words)))))
    (and number
         (pair? (cdr words))
         (let ((unit (and (symbol? (cadr words)) (assq-ref units (cadr words)))))
           (and unit (cons (* unit number) (cddr words)))))))

;; The value that PART of a pattern takes from the head of WORDS: (VALUE . REST), VALUE #f where it says nothing, or #f.
(define (taken part words)
  (cond ((eq? part '<length>) (measured words length-units))
        ((eq? part '<angle>) (measured words angle-units))
        ((eq? part '<part>) (measured words part-units))
        ((null? words) #f)
        ((eq? part '<name>)
         (and (symbol? (car words)) (object-name? (car words)) (cons (car words) (cdr words))))
        ((pair? part) (and (memq (car words) part) (cons (car words) (cdr words))))
        (else (and (eq? part (car words)) (cons #f (cdr words))))))

;; The values found where WORDS say PATTERN, in order, or #f.
(define (found-in pattern words)
  (let loop ((pattern pattern) (words words) (found '()))
    (if (null? pattern)
        (and (null? words) (reverse found))
        (let ((took (taken (car pattern) words)))
          (and took
               (loop (cdr pattern) (cdr took) (if (car took) (cons (car took) found) found)))))))

;; MEANING with what was found in place of its numbers; those of the gripper's own openings are no places.
(define (filled meaning found)
  (cond ((pair? meaning) (map (lambda (part) (filled part found)) meaning))
        ((and (integer? meaning) (<= 1 meaning (length found))) (list-ref found (- meaning 1)))
        (else meaning)))

(define (meaning-of words)
  (any (lambda (sentence)
         (let ((found (found-in (first sentence) words)))
           (and found (filled (second sentence) found))))
       sentences))

;; ---- what is wrong where nothing fits

(define measures
  `((<length> ,length-units "a length" (mm cm m inches))
    (<angle> ,angle-units "an angle" (degrees))
    (<part> ,part-units "a speed" (percent))))

;; How far NODES say PATTERN: (COUNT PART NODES), what part they come to grief at, #f behind the last, and what is left.
(define (way-along pattern nodes)
  (let loop ((count 0) (pattern pattern) (nodes nodes))
    (let ((took (and (pair? pattern) (taken (car pattern) (map node-datum nodes)))))
      (if took
          (loop (+ count 1) (cdr pattern) (take-right nodes (length (cdr took))))
          (list count (and (pair? pattern) (car pattern)) nodes)))))

;; The number or the unit at the head of NODES that is none of PART's.
(define (complain-about-measure part nodes root)
  (let* ((measure (assq part measures))
         (what (third measure))
         (units (fourth measure)))
    (cond ((null? nodes) (complain! root 'not-understood "~a is missing~a" what (suggestion #f units)))
          ((not (number-of (node-datum (first nodes))))
           (complain! (first nodes) 'not-understood "~a is no number: ~a must stand here" (node-datum (first nodes)) what))
          ((null? (cdr nodes))
           (complain! (first nodes) 'not-understood "~a has no unit: ~a is in one~a" (node-datum (first nodes)) what
                      (suggestion #f units)))
          (else
           (let ((unit (node-datum (second nodes))))
             (complain! (second nodes) 'not-understood "~a is no unit of ~a~a" unit what
                        (suggestion (and (symbol? unit) unit) (map car (second measure)))))))))

;; The word that is not known, if any is to blame, and what it was probably meant to be.
(define (complain-about-words nodes root)
  (let ((strange (find (lambda (node)
                         (let ((word (node-datum node)))
                           (and (symbol? word) (not (memq word known-words)) (nearest-name word known-words))))
                       nodes)))
    (if strange
        (complain! strange 'not-understood "~a is not understood~a" (node-datum strange)
                   (suggestion (node-datum strange) known-words))
        (complain! root 'not-understood
                   "this is not understood; say it like: move left 5 centimetres, or: pick up the circle"))))

(define (complain-about nodes root)
  (let* ((ways (map (lambda (sentence) (way-along (first sentence) nodes)) sentences))
         (best (fold (lambda (way best) (if (> (first way) (first best)) way best)) (first ways) (cdr ways)))
         (part (second best)))
    (cond ((zero? (first best)) (complain-about-words nodes root))
          ((assq part measures) (complain-about-measure part (third best) root))
          ((not part)
           (complain! (first (third best)) 'not-understood "~a is not understood here" (node-datum (first (third best)))))
          (else (complain-about-words nodes root)))))

(define (interpret data)
  (interpreting data
    (lambda (root)
      (let* ((nodes (filter (lambda (node) (not (memq (node-datum node) fillers))) (node-items root)))
             (meaning (meaning-of (map node-datum nodes))))
        (or meaning (complain-about nodes root))))))
