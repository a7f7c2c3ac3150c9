;; The gripper of a cell that has a controller of its own: see lisp/forms/gripper_setup.hpp for what is said of it.
;;
;; (gripper-of-section NODE), NODE the section (gripper (driver ...) OPTION ...) of an arm, answers
;;   (PROTOCOL PLACE PORT UNIT (CLOSED-MM OPEN-MM) (CLOSED-COUNT OPEN-COUNT) SPEED FORCE ((REGISTER LOW-BIT BITS) ...))
;; SPEED and FORCE in percent, the registers in the order of `fields`; or () where it cannot be said.

(define-module (pizarra gripper)
  #:use-module (srfi srfi-1)
  #:use-module (pizarra driver)
  #:use-module (pizarra forms)
  #:export (gripper-of-section))

(define protocols '((modbus ("the gripper's address") (502))))

;; The values written to a gripper, the values read from it, and their registers on Robotiq's two-finger grippers.
(define orders
  '((activate 1000 8 1) (go 1000 11 1) (target 1001 0 8) (speed 1002 8 8) (force 1002 0 8)))
(define states
  '((active 2000 12 2) (object 2000 14 2) (fault 2001 8 8) (opening 2002 8 8)))
(define fields (append orders states))
(define most-registers 100)     ; in one request
(define register-bits 16)

;; ---- where what lies

;; The whole numbers of a section that may be missing.
(define (whole-numbers-in found name ranges otherwise)
  (let ((node (section-in found name))
        (numbers (numbers-in found name ranges otherwise)))
    (if (every exact-integer? numbers)
        numbers
        (or (complain! node 'malformed "(~a ...) takes whole numbers" name) otherwise))))

;; (NAME REGISTER LOW-BIT BITS) of each field, where the registers that are given say so or else as it is by default.
(define (fields-of node)
  (let ((given (if node (sections (node-rest (node-within node "in the registers")) (map first fields)) '())))
    (map (lambda (field)
           (let ((place (whole-numbers-in given (first field) `((0 65535) (0 15) (1 ,register-bits)) (cdr field))))
             (when (> (+ (second place) (third place)) register-bits)
               (complain! (section-in given (first field)) 'out-of-range "a register has ~a bits" register-bits))
             (cons (first field) place)))
         fields)))

(define (refuse-far-apart node places names what)
  (let ((numbers (map second (filter (lambda (place) (assq (first place) names)) places))))
    (when (>= (- (apply max numbers) (apply min numbers)) most-registers)
      (complain! node 'out-of-range "the registers to ~a must lie within ~a of each other" what most-registers))))

(define (refuse-overflow node counts places)
  (for-each (lambda (name)
              (let ((bits (fourth (assq name places))))
                (unless (every (lambda (count) (< count (expt 2 bits))) counts)
                  (complain! node 'out-of-range "the ~a has ~a bits, too few for these counts" name bits))))
            '(target opening)))

(define (refuse-same node values what)
  (when (= (first values) (second values))
    (complain! node 'malformed "~a of the closed and of the open gripper must differ" what)))

(define (gripper-of-section node)
  (let* ((inside (node-within node "in the gripper"))
         (found (sections (node-rest inside) '(driver unit opening counts speed force registers)))
         (driver (section-in found 'driver))
         (reached (if driver
                      (driver-of-section driver protocols)
                      (or (complain! inside 'malformed "the gripper needs (driver modbus \"HOST\" PORT)") '())))
         (unit (whole-numbers-in found 'unit '((0 255)) '(9)))
         (opening (numbers-in found 'opening '((0 1000) (0 1000)) '(0 100)))
         (counts (whole-numbers-in found 'counts '((0 65535) (0 65535)) '(255 0)))
         (speed (numbers-in found 'speed '((0 100)) '(100)))
         (force (numbers-in found 'force '((0 100)) '(20)))
         (registers (section-in found 'registers))
         (places (fields-of registers)))
    (refuse-same (section-in found 'opening) opening "the openings")
    (refuse-same (section-in found 'counts) counts "the counts")
    (refuse-overflow (or (section-in found 'counts) registers inside) counts places)
    (when registers
      (refuse-far-apart registers places orders "write")
      (refuse-far-apart registers places states "read"))
    (if (null? reached)
        '()
        (list (first reached) (first (second reached)) (first (third reached))
              (first unit) opening counts (first speed) (first force) (map cdr places)))))
