(use-modules (pizarra cell) (pizarra checks))

(define (cubes-in . cubes)
  (fourth-of (interpret `((cell c (world ,@cubes))))))

(define (fourth-of outcome)
  (if (eq? (car outcome) 'ok) (list-ref (cadr outcome) 3) outcome))

(define (complaint . parts)
  (let ((outcome (interpret (list (cons* 'cell 'c parts)))))
    (if (eq? (car outcome) 'errors) (list (length (cdr outcome)) (car (cadr outcome)) (caddr (cadr outcome))) outcome)))

(check "what is left out has a default" (interpret '((cell c)))
       '(ok (c (1330 0 200 0 0 0 "" 10 ()) (3 0.7 0.12) () crs-f3 "" "localhost" ""
               (("localhost" "" robot vision planner coordinator person)) 60 (76 84 96) (450 -200 200) "" ("" "" 0 ()) () () "" () () () 10 () () () ((1330 0 200 0 0 0) (1 0.1) (30 0 -66) "" ()))))
(check "the gripper opens as the cubes' size asks"
       (list-tail (cadr (interpret '((cell c (world (cube-size 50) (row (x 460) (y -150 150))))))) 9)
       '(50 (66 74 86) (460 -150 150) "" ("" "" 0 ()) () () "" () () () 10 () () () ((1330 0 200 0 0 0) (1 0.1) (30 0 -66) "" ())))
(check "openings are the file's where it says them"
       (list-ref (cadr (interpret '((cell c (world (openings 70 80 90)))))) 10)
       '(70 80 90))
(check "a cube that no gripper takes is refused" (complaint '(world (cube-size 70))) '(1 out-of-range (0 2 1 1)))
(check "openings that a cube does not fit between are refused"
       (complaint '(world (openings 60 84 96))) '(1 out-of-range (0 2 1 1)))
(check "openings have an order" (complaint '(world (openings 96 84 76))) '(1 malformed (0 2 1)))
(check "a row has a beginning and an end" (complaint '(world (row (y 200 -200)))) '(1 malformed (0 2 1 1)))
(check "smaller cubes may stand closer"
       (list (complaint '(world (cube circle (at 450 0)) (cube cross (at 450 55))))
             (car (complaint '(world (cube-size 50) (cube circle (at 450 0)) (cube cross (at 450 55))))))
       '((1 overlap (0 2 2)) ok))
(check "cubes may have sizes of their own, none above the cell's"
       (list (cubes-in '(cube circle (size 40) (at 450 0)) '(cube square (size 50) (at 450 46)))
             (complaint '(world (cube-size 50) (cube circle (size 60) (at 450 0))))
             (complaint '(world (cube circle (size 40) (at 450 0)) (cube square (size 50) (at 450 44)))))
       '(((circle circle 450 0 0 "" 40) (square square 450 46 0 "" 50)) (1 out-of-range (0 2 2 2 1)) (1 overlap (0 2 2))))
(check "a mark is the cube's name where it is one" (cubes-in '(cube circle (at 450 0) (yaw 5)))
       '((circle circle 450 0 5 "" 60)))
(check "a stacked cube stands where the lower one does"
       (cubes-in '(cube circle (at 450 0)) '(cube lid (mark cross) (on circle)))
       '((circle circle 450 0 0 "" 60) (lid cross 450 0 0 circle 60)))
(check "a cube needs a place" (complaint '(world (cube circle))) '(1 malformed (0 2 1)))
(check "a cube cannot stand on a later one" (complaint '(world (cube circle (on cross)) (cube cross (at 450 0))))
       '(1 unknown-object (0 2 1 2)))
(check "two cubes cannot stand on one"
       (complaint '(world (cube circle (at 450 0)) (cube cross (on circle)) (cube square (on circle))))
       '(1 occupied (0 2 3 2)))
(check "two cubes cannot stand in one place"
       (complaint '(world (cube circle (at 450 0)) (cube cross (at 455 10)))) '(1 overlap (0 2 2)))
(check "names are told apart without case"
       (complaint '(world (cube circle (at 450 0)) (cube Circle (mark circle) (at 450 100)))) '(1 repeated (0 2 2)))
(check "an unknown mark is refused" (complaint '(world (cube a (mark star) (at 450 0)))) '(1 unknown-name (0 2 1 2 1)))
(check "a blur up to what the renderer can make is accepted" (car (complaint '(world (noise (blur 2))))) 'ok)
(check "a wider blur is refused" (complaint '(world (noise (blur 2.1)))) '(1 out-of-range (0 2 1 1 1)))
(check "what cannot be reached is refused" (complaint '(world (cube circle (at 4500 0)))) '(1 out-of-range (0 2 1 2 1)))
(check "an agent runs on one host"
       (complaint '(host "a" (agents robot)) '(host "b" (agents robot))) '(1 repeated (0 3 2 1)))
(check "a host's name cannot lead out of its folder" (complaint '(host "../a" (agents robot))) '(1 malformed (0 2 1)))
;; The last element is the folder of the board's keys, the ninth the hosts.
(define (keys-of . sections)
  (let ((cell (cadr (interpret (list (append '(cell c) sections))))))
    (list (list-ref cell 12) (list-ref cell 8))))
(check "a board's folder of keys and a host's own key are named"
       (keys-of '(board "a" "tcp://a:7800" (keys "keys")) '(host "a" (agents robot)) '(host "b" (agents) (key "b.secret")))
       '("keys" (("a" "" robot) ("b" "b.secret"))))
(check "a folder of keys is text" (complaint '(board "a" "tcp://a:7800" (keys 5))) '(1 malformed (0 2 3 1)))
(define (pan-tilt-of . sections)
  (let ((cell (cadr (interpret (list (append '(cell c) sections))))))
    (list (list-ref (list-ref cell 1) 6) (list-ref cell 13) (memq 'pan-tilt (car (list-ref cell 8))))))
(check "cameras on a pan-tilt unit bring the agent that turns it"
       (pan-tilt-of '(world (camera (head ptu46-70))))
       '(ptu46-70 ("" "" 0 ()) (pan-tilt planner coordinator person)))
(define (agents-of . sections)
  (cddar (list-ref (cadr (interpret (list (append '(cell c) sections)))) 8)))
(check "nobody moves a real arm by himself who is not named"
       (list (agents-of '(arm crs-f3)) (agents-of '(arm crs-f3 (driver hses "10.0.0.3")))
             (agents-of '(arm crs-f3 (driver hses "10.0.0.3")) '(host "a" (agents robot person))))
       '((robot vision planner coordinator person) (robot vision planner coordinator) (robot person)))
(check "a unit on a serial line runs at 9600 baud unless told otherwise"
       (cadr (pan-tilt-of '(pan-tilt (serial "/dev/ttyUSB0")))) '(serial "/dev/ttyUSB0" 9600 ()))
(check "a unit on a network counts as it is said to"
       (cadr (pan-tilt-of '(pan-tilt (tcp "ptu" 4000) (reversed tilt)))) '(tcp "ptu" 4000 (tilt)))
;; The last element is where the agents take the camera to be, the second where it stands.
(define (camera-poses-of . sections)
  (let ((cell (cadr (interpret (list (append '(cell c) sections))))))
    (list (list-ref cell 1) (list-ref cell 24))))
(check "agents take the camera to be where the world has it"
       (camera-poses-of '(world (camera (at 1350 0 210) (roll 1))))
       '((1350 0 210 0 0 1 "" 10 ()) ((1350 0 210 0 0 1) (1 0.1) (30 0 -66) "" ())))
(check "agents know the axes of the unit as well as the world does"
       (camera-poses-of
        '(world (camera (head ptu46-70 (pan-axis (at 5 0 -38) (along 0 1 0)) (tilt-axis (at 0 52 0) (along 1 0 0))))))
       '((1330 0 200 0 0 0 ptu46-70 10 ((5 0 -38) (0 1 0) (0 52 0) (1 0 0)))
         ((1330 0 200 0 0 0) (1 0.1) (30 0 -66) "" ((5 0 -38) (0 1 0) (0 52 0) (1 0 0)))))
(check "agents may take it to be elsewhere, until a file says better"
       (camera-poses-of '(world (camera (at 1350 0 210))) '(camera-pose (at 1330 5 200) (file "camera.scm")))
       '((1350 0 210 0 0 0 "" 10 ()) ((1330 5 200 0 0 0) (20 2) (30 0 -66) "camera.scm" ())))
(check "a camera that stands still has no axes"
       (complaint '(camera-pose (at 1330 0 200) (head (pan-axis (at 5 0 -38) (along 0 1 0)) (tilt-axis (at 0 5 0) (along 1 0 0)))))
       '(1 malformed (0 2 2)))
(check "a camera's pose needs its place" (complaint '(camera-pose (pan 3))) '(1 malformed (0 2 2)))
(check "the simulated cameras take as many frames as they are told to"
       (list-ref (car (camera-poses-of '(world (camera (rate 30))))) 7) 30)
(check "a frame takes a whole number of the world's steps"
       (complaint '(world (camera (rate 50)))) '(1 out-of-range (0 2 1 1)))
(check "a unit that is not known is refused" (complaint '(world (camera (head ptu47)))) '(1 unknown-name (0 2 1 1 1)))
(check "a unit needs a line" (complaint '(pan-tilt)) '(1 malformed (0 2)))
(check "a line is serial or tcp" (complaint '(pan-tilt (usb 3))) '(1 malformed (0 2 1)))
(check "a serial line has one of the known speeds" (complaint '(pan-tilt (serial "/dev/x" 1200))) '(1 out-of-range (0 2 1 2)))
(check "a port is a port" (complaint '(pan-tilt (tcp "ptu" 70000))) '(1 out-of-range (0 2 1 2)))
(check "an agent without anything to turn is refused"
       (complaint '(host "a" (agents robot pan-tilt))) '(1 unknown-agent (0 2 2 2)))
(check "what the eyes learn is kept in a folder where one is named"
       (list-ref (cadr (interpret '((cell c (objects "learned"))))) 16) "learned")
(check "the folder of the objects is text" (complaint '(objects learned)) '(1 malformed (0 2 1)))
(check "an arm may be given room"
       (list-ref (cadr (interpret '((cell c (arm crs-f3 (room (x 200 600) (z 20 700))))))) 14)
       '((200 600) (-10000 10000) (20 700)))
(check "an arm's room has its low ends first" (complaint '(arm crs-f3 (room (z 700 20)))) '(1 malformed (0 2 2 1)))
;; How the arm's controller is reached.
(define (driver-of . parts)
  (list-ref (cadr (interpret `((cell c (arm crs-f3 ,@parts))))) 15))
(check "an arm's controller is reached by its protocol"
       (list (driver-of '(driver hses "10.0.0.3")) (driver-of '(room (z 20 700)) '(driver hses "up6" 10041)) (driver-of))
       '((hses ("10.0.0.3") (10040)) (hses ("up6") (10041)) ()))
(check "a protocol has as many places and ports as it needs"
       (list (driver-of '(driver universal "ur" 1 2)) (driver-of '(driver c500c "/dev/ttyS1" "/dev/ttyS0"))
             (driver-of '(driver ethernet-server "nx")) (driver-of '(driver bsc "/dev/ttyS0"))
             (driver-of '(driver simple-message-track "f3"))
             (driver-of '(driver simple-message-track-big-endian "f3" 50240 50241))
             (driver-of '(driver motoros "up6")) (driver-of '(driver motoros-big-endian "up6" 1 2)))
       '((universal ("ur") (1 2 29999)) (c500c ("/dev/ttyS1" "/dev/ttyS0") ()) (ethernet-server ("nx") (80))
         (bsc ("/dev/ttyS0") ()) (simple-message-track ("f3") (11000 11002))
         (simple-message-track-big-endian ("f3") (50240 50241))
         (motoros ("up6") (50240 50241)) (motoros-big-endian ("up6") (1 2))))
(check "a protocol that is not known is refused"
       (complaint '(arm crs-f3 (driver hse "a"))) '(1 unknown-name (0 2 2 1)))
(check "a controller has an address" (complaint '(arm crs-f3 (driver hses))) '(1 malformed (0 2 2)))
(check "a controller's port is a port" (complaint '(arm crs-f3 (driver hses "a" 70000))) '(1 out-of-range (0 2 2 3)))
(check "a controller has no more ports than its protocol"
       (complaint '(arm crs-f3 (driver hses "a" 1 2))) '(1 malformed (0 2 2 4)))
(check "an arm tells its state as often as its section says"
       (list-ref (cadr (interpret '((cell c (arm crs-f3 (rate 125)))))) 20) 125)
(check "an arm tells its state 500 times a second at most" (complaint '(arm crs-f3 (rate 501))) '(1 out-of-range (0 2 2 1)))
;; A second arm.
(define (slave-of . parts)
  (list-ref (cadr (interpret `((cell c ,@parts)))) 18))
(check "a second arm has a place for each of the first's"
       (list (slave-of '(slave crs-f3 (offset 10 -20 30) (mirror) (driver hses "up6")))
             (slave-of '(slave crs-f3 (room (z 20 700)))) (slave-of))
       '((crs-f3 () (hses ("up6") (10040)) (10 -20 30) mirror () 10)
         (crs-f3 ((-10000 10000) (-10000 10000) (20 700)) () (0 0 0) plain () 10) ()))
(check "a second arm is of those there are" (complaint '(slave kr3)) '(1 unknown-name (0 2 1)))
(check "an offset has three lengths" (complaint '(slave crs-f3 (offset 10 20))) '(1 malformed (0 2 2)))
(check "agents of a second arm need one"
       (complaint '(host "a" (agents robot slave follower))) '(2 unknown-agent (0 2 2 2)))
(check "another agent of a kind is called by its number"
       (agents-of '(host "a" (agents robot vision vision-2 planner-3))) '(robot vision vision-2 planner-3))
(check "a number makes no kind" (complaint '(host "a" (agents robt-2))) '(1 unknown-agent (0 2 2 1)))
(check "another agent needs a device as the first does"
       (complaint '(host "a" (agents robot pan-tilt-2))) '(1 unknown-agent (0 2 2 2)))
;; Agents that are Scheme files.
(define (scheme-agents-of . parts)
  (list-ref (cadr (interpret `((cell c ,@parts)))) 21))
(check "an agent of one's own has a file and limits"
       (list (scheme-agents-of '(agent belt (scheme "b.scm")))
             (scheme-agents-of '(agent belt (scheme "b.scm") (time 50) (memory 16) (rate 10) (key "k"))) (scheme-agents-of))
       '(((belt "b.scm" 1000 64 1000 "")) ((belt "b.scm" 50 16 10 "k")) ()))
(check "the one host runs it"
       (memq 'belt (caar (list-tail (cadr (interpret '((cell c (agent belt (scheme "b.scm")))))) 8)))
       '(belt))
(check "hosts that are named must name it"
       (complaint '(agent belt (scheme "b.scm")) '(host "a" (agents robot))) '(1 unknown-agent (0 2)))
(check "an agent has a file" (complaint '(agent belt (time 50))) '(1 malformed (0 2 3)))
(check "an agent has a name of its own"
       (complaint '(agent robot (scheme "b.scm"))) '(1 repeated (0 2 1)))
(check "an agent is called like none of the processes that a cell runs besides"
       (map (lambda (name) (complaint `(agent ,name (scheme "b.scm"))))
            '(board world log door console arm-plugin camera-plugin narrator))
       (make-list 8 '(1 repeated (0 2 1))))
(check "no two agents have one name"
       (complaint '(agent a (scheme "b.scm")) '(agent a (scheme "c.scm"))) '(1 repeated (0 3)))
(check "limits are within their bounds" (complaint '(agent a (scheme "b.scm") (time 5))) '(1 out-of-range (0 2 3 1)))
(check "every error is told" (complaint '(wrld) '(arm kr3) '(host "a" (agents robt))) '(3 unknown-section (0 2)))

(define (door . parts)
  (let ((outcome (interpret `((cell c (door ,@parts))))))
    (if (eq? (car outcome) 'ok)
        (list-ref (cadr outcome) 23)
        (map (lambda (complaint) (list (car complaint) (caddr complaint))) (cdr outcome)))))

(check "a cell has no door unless it says so" (list-ref (cadr (interpret '((cell c)))) 23) '())
(check "a door is reached over TCP and serial lines"
       (door '(tcp 7801) '(serial "/dev/ttyUSB0" 9600) '(serial "/dev/ttyS1") '(keys "keys"))
       '(7801 (("/dev/ttyUSB0" 9600) ("/dev/ttyS1" 115200)) "keys"))
(check "a door takes the board's keys"
       (list-ref (cadr (interpret '((cell c (board "localhost" "tcp://bench:7800" (keys "all")) (door (tcp 1)))))) 23)
       '(1 () "all"))
(check "a door is reached somehow" (door '(keys "keys")) '((malformed (0 2))))
(check "a door has keys" (door '(tcp 7801)) '((malformed (0 2))))
(check "a port is a port" (door '(tcp 70000) '(keys "k")) '((out-of-range (0 2 1 1))))
(check "a line is a device" (door '(serial "ttyUSB0") '(keys "k")) '((malformed (0 2 1 1))))
(check "a line runs at a known rate" (door '(serial "/dev/ttyUSB0" 1000) '(keys "k")) '((out-of-range (0 2 1 2))))
(check "a word that is not known is refused" (door '(tcp 7801) '(keys "k") '(udp 1)) '((unknown-section (0 2 3))))

(finish-checks)
