(use-modules (pizarra cell-test-checks) (pizarra test-checks))

;; The value of a cell file with these words in its arm's (gripper ...), or how many complaints it has and the first
;; one.
(define (gripper . words)
  (cell-part 'gripper `(arm crs-f3 (gripper ,@words))))

(define driver '(driver modbus "10.0.0.9"))

(check "an arm without words about its gripper has its own"
       (cell-part 'gripper '(arm crs-f3)) '())
(check "a gripper is laid out as the commonest are" (gripper driver)
       '(modbus "10.0.0.9" 502 9 (0 100) (255 0) 100 20
         ((1000 8 1) (1000 11 1) (1001 0 8) (1002 8 8) (1002 0 8)
          (2000 12 2) (2000 14 2) (2001 8 8) (2002 8 8))))
(check "all of it can be said"
       (gripper '(driver modbus "g" 1502) '(unit 1) '(opening 2.5 85) '(counts 0 1000) '(speed 50) '(force 5)
                '(registers (target 1001 0 10) (opening 2003 0 16)))
       '(modbus "g" 1502 1 (2.5 85) (0 1000) 50 5
         ((1000 8 1) (1000 11 1) (1001 0 10) (1002 8 8) (1002 0 8)
          (2000 12 2) (2000 14 2) (2001 8 8) (2003 0 16))))
(check "a gripper without a driver is nowhere" (gripper '(unit 1)) '(1 malformed (0 2 2)))
(check "its protocol is known" (gripper '(driver modbos "g")) '(1 unknown-name (0 2 2 1 1)))
(check "an option that is not known is refused" (gripper driver '(strength 3)) '(1 unknown-section (0 2 2 2)))
(check "a unit is a number of a unit" (gripper driver '(unit 300)) '(1 out-of-range (0 2 2 2 1)))
(check "a unit is a whole number" (gripper driver '(unit 1.5)) '(1 malformed (0 2 2 2)))
(check "fingers that do not open are none" (gripper driver '(opening 85 85)) '(1 malformed (0 2 2 2)))
(check "counts that do not differ say nothing" (gripper driver '(counts 7 7)) '(1 malformed (0 2 2 2)))
(check "counts go into their registers" (gripper driver '(counts 0 1000)) '(2 out-of-range (0 2 2 2)))
(check "a register has 16 bits" (gripper driver '(registers (force 1002 10 8))) '(1 out-of-range (0 2 2 2 1)))
(check "a field that is not known is refused" (gripper driver '(registers (grip 1 2 3))) '(1 unknown-section (0 2 2 2 1)))
(check "what is told goes over in one request" (gripper driver '(registers (force 5 0 8))) '(1 out-of-range (0 2 2 2)))

(finish-checks)
