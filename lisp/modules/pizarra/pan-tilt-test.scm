(use-modules (pizarra cell-test-checks) (pizarra test-checks))

(define (pan-tilt . parts)
  (cell-part 'pan-tilt `(pan-tilt ,@parts)))

(check "a unit on a serial line runs at 9600 baud unless told otherwise"
       (pan-tilt '(serial "/dev/ttyUSB0")) '(serial "/dev/ttyUSB0" 9600 ()))
(check "a unit on a network counts as it is said to"
       (pan-tilt '(tcp "ptu" 4000) '(reversed tilt)) '(tcp "ptu" 4000 (tilt)))
(check "a unit needs a line" (pan-tilt) '(1 malformed (0 2)))
(check "a line is serial or tcp" (pan-tilt '(usb 3)) '(1 malformed (0 2 1)))
(check "a cell without words about its unit has the simulated one or none" (cell-part 'pan-tilt) '("" "" 0 ()))
(check "its axes are pan and tilt" (pan-tilt '(tcp "ptu" 4000) '(reversed yaw)) '(1 unknown-name (0 2 2 1)))

(finish-checks)
