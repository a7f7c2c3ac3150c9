(use-modules (pizarra cell) (pizarra cell-test-checks) (pizarra test-checks))

(check "what is left out has a default" (interpret '((cell c)))
       '(ok ((name c) (camera (1330 0 200 0 0 0 "" 10 (320 240) ())) (noise (3 0.7 0.12)) (cubes ()) (arm crs-f3)
             (domain "") (board-host "localhost") (board-address "")
             (hosts (("localhost" "" robot vision planner coordinator person)))
             (cube-size 60) (openings (76 84 96)) (row (450 -200 200)) (board-keys "") (pan-tilt ("" "" 0 ()))
             (room ()) (driver ()) (objects "") (eyes ()) (slave ()) (gripper ()) (rate 10) (agents ()) (tags ())
             (door ()) (camera-pose ((1330 0 200 0 0 0) (20 2) (30 0 -66) "" ())) (lamp ()) (tagged ())
             (background ()) (table-picture ()) (lens (0 0 0 0 0)) (bodies ()) (things ()))))
(check "a blur up to what the renderer can make is accepted" (car (complaint '(world (noise (blur 2))))) 'ok)
(check "a wider blur is refused" (complaint '(world (noise (blur 2.1)))) '(1 out-of-range (0 2 1 1 1)))
(define (agents-of . sections)
  (cddar (apply cell-part 'hosts sections)))
(check "a second lamp has a place and a part of the light"
       (list (cell-part 'lamp '(world (lamp (at 900 -600 1200)))) (cell-part 'lamp '(world (lamp (part 0.6) (at 0 0 900)))))
       '((900 -600 1200 0.4) (0 0 900 0.6)))
(check "a lamp without a place, among the cubes or too bright is refused"
       (list (complaint '(world (lamp (part 0.4)))) (complaint '(world (lamp (at 900 -600 100))))
             (complaint '(world (lamp (at 900 -600 900) (part 0.8)))))
       '((1 malformed (0 2 1 2)) (1 out-of-range (0 2 1 1 3)) (1 out-of-range (0 2 1 2 1))))
(check "a picture is a file, and where the text names it"
       (list (cell-part 'background '(world (background "wall.jpg"))) (cell-part 'table-picture '(world (table-picture "cloth.png"))))
       '(("wall.jpg" (0 2 1 1)) ("cloth.png" (0 2 1 1))))
(check "a picture without a file, with an empty one or with two is refused"
       (list (complaint '(world (background))) (complaint '(world (background "")))
             (complaint '(world (table-picture "a.png" "b.png"))))
       '((1 malformed (0 2 1)) (1 malformed (0 2 1 1)) (1 malformed (0 2 1 2))))
(check "a lens has the numbers of OpenCV, and those left out are none"
       (list (cell-part 'lens '(world (camera (lens -0.3)))) (cell-part 'lens '(world (camera (lens -0.3 0.1 0.001 0 0.02)))))
       '((-0.3 0 0 0 0) (-0.3 0.1 0.001 0 0.02)))
(check "a lens without a number, with six or out of range is refused"
       (list (complaint '(world (camera (lens)))) (complaint '(world (camera (lens 0 0 0 0 0 0))))
             (complaint '(world (camera (lens -0.3 2)))))
       '((1 malformed (0 2 1 1)) (1 malformed (0 2 1 1)) (1 out-of-range (0 2 1 1 2))))
(check "cameras on a pan-tilt unit bring the agent that turns it"
       (list (list-ref (cell-part 'camera '(world (camera (head ptu46-70)))) 6) (agents-of '(world (camera (head ptu46-70)))))
       '(ptu46-70 (robot vision pan-tilt planner coordinator person)))
(check "nobody moves a real arm by himself who is not named"
       (list (agents-of '(arm crs-f3)) (agents-of '(arm crs-f3 (driver hses "10.0.0.3")))
             (agents-of '(arm crs-f3 (driver hses "10.0.0.3")) '(host "a" (agents robot person))))
       '((robot vision planner coordinator person) (robot vision planner coordinator) (robot person)))
;; Where the camera stands, and where the agents take it to be.
(define (camera-poses-of . sections)
  (map (lambda (part) (apply cell-part part sections)) '(camera camera-pose)))
(check "agents do not know where the world has the camera: they guess the usual place"
       (camera-poses-of '(world (camera (at 1350 0 210) (roll 1))))
       '((1350 0 210 0 0 1 "" 10 (320 240) ()) ((1330 0 200 0 0 0) (20 2) (30 0 -66) "" ())))
(check "agents do not know the axes of the unit in the world"
       (camera-poses-of
        '(world (camera (head ptu46-70 (pan-axis (at 5 0 -38) (along 0 1 0)) (tilt-axis (at 0 52 0) (along 1 0 0))))))
       '((1330 0 200 0 0 0 ptu46-70 10 (320 240) ((5 0 -38) (0 1 0) (0 52 0) (1 0 0)))
         ((1330 0 200 0 0 0) (20 2) (30 0 -66) "" ())))
(check "agents may take it to be elsewhere, until a file says better"
       (camera-poses-of '(world (camera (at 1350 0 210))) '(camera-pose (at 1330 5 200) (file "camera.scm")))
       '((1350 0 210 0 0 0 "" 10 (320 240) ()) ((1330 5 200 0 0 0) (20 2) (30 0 -66) "camera.scm" ())))
(check "a camera that stands still has no axes"
       (complaint '(camera-pose (at 1330 0 200) (head (pan-axis (at 5 0 -38) (along 0 1 0)) (tilt-axis (at 0 5 0) (along 1 0 0)))))
       '(1 malformed (0 2 2)))
(check "a camera's pose needs its place" (complaint '(camera-pose (pan 3))) '(1 malformed (0 2 2)))
(check "the simulated cameras take as many frames as they are told to"
       (list-ref (car (camera-poses-of '(world (camera (rate 30))))) 7) 30)
(check "a frame takes a whole number of the world's steps"
       (complaint '(world (camera (rate 50)))) '(1 out-of-range (0 2 1 1)))
(check "the simulated cameras take larger images where they are told to"
       (list-ref (car (camera-poses-of '(world (camera (size 640 480))))) 8) '(640 480))
(check "an image is as wide as 320 columns, 640 or 1280, and not stretched"
       (list (complaint '(world (camera (size 320 200)))) (complaint '(world (camera (size 640)))))
       '((1 out-of-range (0 2 1 1)) (1 malformed (0 2 1 1))))
(check "a unit that is not known is refused" (complaint '(world (camera (head ptu47)))) '(1 unknown-name (0 2 1 1 1)))
(check "an agent without anything to turn is refused"
       (complaint '(host "a" (agents robot pan-tilt))) '(1 unknown-agent (0 2 2 2)))
(check "what the eyes learn is kept in a folder where one is named"
       (cell-part 'objects '(objects "learned")) "learned")
(check "the folder of the objects is text" (complaint '(objects learned)) '(1 malformed (0 2 1)))
(check "an arm may be given room"
       (cell-part 'room '(arm crs-f3 (room (x 200 600) (z 20 700))))
       '((200 600) (-10000 10000) (20 700)))
(check "an arm's room has its low ends first" (complaint '(arm crs-f3 (room (z 700 20)))) '(1 malformed (0 2 2 1)))
;; How the arm's controller is reached.
(define (driver-of . parts)
  (cell-part 'driver `(arm crs-f3 ,@parts)))
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
       (cell-part 'rate '(arm crs-f3 (rate 125))) 125)
(check "an arm tells its state 500 times a second at most" (complaint '(arm crs-f3 (rate 501))) '(1 out-of-range (0 2 2 1)))
;; A second arm.
(define (slave-of . parts)
  (apply cell-part 'slave parts))
(check "a second arm has a place for each of the first's"
       (list (slave-of '(slave crs-f3 (offset 10 -20 30) (mirror) (driver hses "up6")))
             (slave-of '(slave crs-f3 (room (z 20 700)))) (slave-of))
       '((crs-f3 () (hses ("up6") (10040)) (10 -20 30) mirror () 10)
         (crs-f3 ((-10000 10000) (-10000 10000) (20 700)) () (0 0 0) plain () 10) ()))
(check "a second arm is of those there are" (complaint '(slave kr3)) '(1 unknown-name (0 2 1)))
(check "an offset has three lengths" (complaint '(slave crs-f3 (offset 10 20))) '(1 malformed (0 2 2)))
(check "agents of a second arm need one"
       (complaint '(host "a" (agents robot slave follower))) '(2 unknown-agent (0 2 2 2)))
(check "every error is told" (complaint '(wrld) '(arm kr3) '(host "a" (agents robt))) '(3 unknown-section (0 2)))

(finish-checks)
