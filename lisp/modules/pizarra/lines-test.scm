(use-modules (pizarra cell-test-checks) (pizarra test-checks))

(check "a serial line has one of the known speeds" (complaint '(pan-tilt (serial "/dev/x" 1200))) '(1 out-of-range (0 2 1 2)))
(check "so has a door's" (complaint '(door (serial "/dev/ttyUSB0" 1000) (keys "k"))) '(1 out-of-range (0 2 1 2)))
(check "a port is a port" (complaint '(pan-tilt (tcp "ptu" 70000))) '(1 out-of-range (0 2 1 2)))
(check "a port may be left to the system at a door alone"
       (list (complaint '(pan-tilt (tcp "ptu" 0))) (cell-part 'door '(door (tcp 0) (keys "k"))) (complaint '(door (tcp -1) (keys "k"))))
       '((1 out-of-range (0 2 1 2)) (0 () "k") (1 out-of-range (0 2 1 1))))

(finish-checks)
