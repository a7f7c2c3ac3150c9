(use-modules (pizarra cell-test-checks) (pizarra test-checks))

(define (door . parts)
  (cell-part 'door `(door ,@parts)))

(check "a cell has no door unless it says so" (cell-part 'door) '())
(check "a door is reached over TCP and serial lines"
       (door '(tcp 7801) '(serial "/dev/ttyUSB0" 9600) '(serial "/dev/ttyS1") '(keys "keys"))
       '(7801 (("/dev/ttyUSB0" 9600) ("/dev/ttyS1" 115200)) "keys"))
(check "a door takes the board's keys"
       (cell-part 'door '(board "localhost" "tcp://bench:7800" (keys "all")) '(door (tcp 1)))
       '(1 () "all"))
(check "a door is reached somehow" (door '(keys "keys")) '(1 malformed (0 2)))
(check "a door has keys" (door '(tcp 7801)) '(1 malformed (0 2)))
(check "a line is a device" (door '(serial "ttyUSB0") '(keys "k")) '(1 malformed (0 2 1 1)))
(check "a word that is not known is refused" (door '(tcp 7801) '(keys "k") '(udp 1)) '(1 unknown-section (0 2 3)))

(finish-checks)
