;; Cell files: see lisp/forms/cell_file.hpp for the language and for what is taken where something is left out.
;;
;; (interpret DATA), the data of a file, answers (errors ...) or (ok ((PART VALUE) ...)). C++ reads the parts by their
;; names (lisp/forms/cell_file.cpp):
;;   name
;;   camera         (X Y Z PAN TILT ROLL HEAD FRAMES (WIDTH HEIGHT) AXES), the world's: HEAD is the simulated pan-tilt
;;                  unit under the cameras or the empty string, FRAMES how many a second they take
;;   noise          (SENSOR BLUR GRADIENT)
;;   lens           the distortion of the simulated cameras, (K1 K2 P1 P2 K3)
;;   lamp           the world's second one, (X Y Z PART), or ()
;;   background, table-picture   photographs in the world, (FILE PATH), PATH leading to where the text names the file,
;;                  or ()
;;   cubes, things  of the world; cube-size, openings and row belong to them (the modules cubes and things)
;;   arm            its name, or its file
;;   room           the arm's, or ()
;;   driver         how the arm's controller is reached, (PROTOCOL (PLACE ...) (NUMBER ...)), or () for the simulated arm
;;   gripper        or () for the arm's own (the module gripper)
;;   rate           how often a second the arm tells its state
;;   slave          the second arm, (ARM ROOM DRIVER (X Y Z) plain|mirror GRIPPER RATE), or ()
;;   eyes           the agent's own cameras, or () for the simulated ones (the module camera)
;;   camera-pose    where the agents take the camera to be (the module camera-pose)
;;   tags, tagged, bodies   ((FAMILY SIDE) ...), ((NAME FAMILY NUMBER SIDE) ...), and the bodies of several tags
;;   objects        the folder of the object database, or empty
;;   domain         the domain's file, or empty
;;   board-host, board-address, board-keys, hosts, agents   the modules hosts and scheme-agents
;;   pan-tilt, door the modules of these names

(define-module (pizarra cell)
  #:use-module (srfi srfi-1)
  #:use-module (pizarra forms)
  #:use-module (pizarra bodies)
  #:use-module (pizarra camera)
  #:use-module (pizarra camera-pose)
  #:use-module (pizarra cubes)
  #:use-module (pizarra door)
  #:use-module (pizarra driver)
  #:use-module (pizarra gripper)
  #:use-module (pizarra hosts)
  #:use-module (pizarra pan-tilt)
  #:use-module (pizarra tags)
  #:use-module (pizarra things)
  #:export (interpret))

;; Sees and points through the simulation alone.
(define simulated-kinds '(person))
(define heads '(ptu46-17.5 ptu46-70))
;; Each takes a whole number of the world's steps.
(define frame-rates '(10 20 30 40 60))
;; They show the same part of the world.
(define image-sizes '((320 240) (640 480) (1280 960)))

;; Above whatever it shines on.
(define lamp-places-mm '((-3000 3000) (-3000 3000) (800 3000)))

;; ---- camera and light

(define (camera-of found)
  (let* ((camera (section-in found 'camera))
         (parts (if camera
                    (sections (node-rest (node-within camera "in the camera")) '(at pan tilt roll head lens rate size))
                    '()))
         (head (section-in parts 'head)))
    (append (pose-of parts)
            (list (if head (or (choice-at head 1 "the pan-tilt unit" heads) "") "")
                  (frame-rate-of parts)
                  (image-size-of parts)
                  (if (and head (> (length (node-items head)) 2)) (axes-of head (drop (node-items head) 2)) '())))))

(define lens-numbers 5)
(define distortion-range '(-1 1))

;; (lens K1 K2 P1 P2 K3), of which the last ones may be left out.
(define (lens-of found)
  (let* ((camera (section-in found 'camera))
         (lens (and camera (find (lambda (item) (eq? (node-head item) 'lens)) (node-rest camera))))
         (given (if lens (length (node-rest lens)) 0))
         (numbers (cond ((not lens) '())
                        ((<= 1 given lens-numbers) (or (numbers-of lens (make-list given distortion-range)) '()))
                        (else (complain! lens 'malformed "(lens K1 K2 P1 P2 K3) takes 1 to ~a numbers" lens-numbers)
                              '()))))
    (append numbers (make-list (- lens-numbers (length numbers)) 0))))

(define (frame-rate-of parts)
  (let ((rate (first (numbers-in parts 'rate '((10 60)) '(10)))))
    (if (memv rate frame-rates)
        rate
        (complain! (section-in parts 'rate) 'out-of-range
                   "the simulated cameras take 10, 20, 30, 40 or 60 frames a second"))))

(define (image-size-of parts)
  (let ((size (numbers-in parts 'size '((1 10000) (1 10000)) (first image-sizes))))
    (if (member size image-sizes)
        size
        (complain! (section-in parts 'size) 'out-of-range
                   "the simulated cameras take images of (size 320 240), (size 640 480) or (size 1280 960)"))))

;; Where the agents take the camera to be. Where it stands in the world is the simulator's alone to know.
(define (believed-camera-of found)
  (let ((section (section-in found 'camera-pose)))
    (if section
        (camera-pose-of-section section '(at pan tilt roll sure mark head file))
        usual-guess)))

;; A camera that stands still turns about nothing.
(define (refuse-axes found)
  (let* ((section (section-in found 'camera-pose))
         (head (and section (find (lambda (item) (eq? (node-head item) 'head)) (node-rest section)))))
    (when head
      (complain! head 'malformed
                 "the cell has no pan-tilt unit: neither (camera (head UNIT)) nor (pan-tilt LINE) is given"))))

(define (noise-of found)
  (let* ((noise (section-in found 'noise))
         (parts (if noise (sections (node-rest (node-within noise "in the noise")) '(sensor blur gradient)) '())))
    (append (numbers-in parts 'sensor '((0 20)) '(3))
            (numbers-in parts 'blur '((0 2)) '(0.7))
            (numbers-in parts 'gradient '((0 0.9)) '(0.12)))))

;; The second lamp, and which part of the light is its own.
(define (lamp-of found)
  (let* ((lamp (section-in found 'lamp))
         (parts (if lamp (sections (node-rest (node-within lamp "in the lamp")) '(at part)) '())))
    (cond ((not lamp) '())
          ((not (section-in parts 'at)) (complain-missing! lamp '(at) "the lamp has no place: (at X Y Z)") '())
          (else (append (numbers-in parts 'at lamp-places-mm '(0 0 1000))
                        (numbers-in parts 'part '((0 0.7)) '(0.4)))))))

(define (picture-of found name)
  (let* ((picture (section-in found name))
         (file (and picture (string-at picture 1 "the picture's file"))))
    (cond ((not file) '())
          ((string-null? file) (complain! (node-ref picture 1) 'malformed "the name of this file is empty") '())
          ((> (length (node-items picture)) 2) (complain! (node-ref picture 2) 'malformed "(~a ...) takes one file" name) '())
          (else (list file (path-to (node-ref picture 1)))))))

;; ---- arms

;; The name of an arm that comes with the tree, a symbol, or the path of an arm file, a string.
(define (arm-of node arms)
  (let ((given (node-ref node 1)))
    (if (and given (string? (node-datum given)))
        (node-datum given)
        (choice-at node 1 "the arm" arms))))

;; How the controllers of arms are reached: the protocol, what its places are, and the ports that may follow, each with
;; what is taken where it is left out.
(define protocols
  '((hses ("the controller's address") (10040))
    (ethernet-server ("the controller's address") (80))
    (bsc ("the line's file") ())
    (universal ("the controller's address") (30004 30002 29999))
    (simple-message ("the controller's address") (11000 11002))
    (simple-message-big-endian ("the controller's address") (11000 11002))
    (simple-message-track ("the controller's address") (11000 11002))
    (simple-message-track-big-endian ("the controller's address") (11000 11002))
    (motoros ("the controller's address") (50240 50241))
    (motoros-big-endian ("the controller's address") (50240 50241))
    (c500c ("the file of the motion's line" "the file of the state's line") ())))

(define (driver-of found)
  (let ((driver (section-in found 'driver)) (plugin (section-in found 'plugin)))
    (cond ((and driver plugin) (complain! plugin 'repeated "an arm has either a driver or a plug-in") '())
          (plugin (list 'plugin (list (or (plugin-at plugin) "")) '()))
          (driver (driver-of-section driver protocols))
          (else '()))))

(define (gripper-of found)
  (let ((gripper (section-in found 'gripper)))
    (if gripper (gripper-of-section gripper) '())))

;; Where the arm's grip centre may be, ((LOW HIGH) (LOW HIGH) (LOW HIGH)), or () for wherever it reaches.
(define (room-of found)
  (let* ((room (section-in found 'room))
         (parts (if room (sections (node-rest (node-within room "in the room")) '(x y z)) '()))
         (span-of (lambda (name)
                    (let ((span (numbers-in parts name '((-10000 10000) (-10000 10000)) '(-10000 10000))))
                      (when (> (first span) (second span))
                        (complain! (section-in parts name) 'malformed "the low end comes first: (~a LOW HIGH)" name))
                      span))))
    (if room (map span-of '(x y z)) '())))

;; The parts of an arm's section after its name.
(define (parts-of arm known)
  (let ((rest (node-rest arm)))
    (sections (if (pair? rest) (cdr rest) '()) known)))

;; How often a second the arm tells where it is while it moves.
(define (rate-of found)
  (first (numbers-in found 'rate '((1 500)) '(10))))

;; (slave ARM (offset X Y Z) (mirror) ...): the second arm, and where it is to be for a place of the first.
(define (slave-of node arms)
  (let ((found (parts-of node '(room driver gripper rate offset mirror))))
    (list (or (arm-of node arms) 'crs-f3)
          (room-of found)
          (driver-of found)
          (numbers-in found 'offset '((-5000 5000) (-5000 5000) (-5000 5000)) '(0 0 0))
          (if (section-in found 'mirror) 'mirror 'plain)
          (gripper-of found)
          (rate-of found))))

;; ----

(define (interpret-sections cell name arms)
  (let* ((found (sections (drop (node-items cell) 2) '(world arm slave camera camera-pose tags tagged bodies pan-tilt objects domain board
                                                          agent host door)
                          '(agent host)))
         (world (section-in found 'world))
         (things (if world
                     (sections (node-rest (node-within world "in the world"))
                               '(background brick camera cube cube-size cylinder lamp noise openings row table-picture)
                               '(brick cube cylinder))
                     '()))
         (size (cube-size-of things))
         (arm (section-in found 'arm))
         (arm-parts (if arm (parts-of (node-within arm "in the arm") '(room driver plugin gripper rate)) '()))
         (slave (section-in found 'slave))
         (camera (camera-of things))
         (pan-tilt (pan-tilt-of found))
         (has-unit (or (section-in found 'pan-tilt) (symbol? (list-ref camera 6))))
         (own-cameras (section-in found 'camera))
         (named-hosts (sections-in found 'host))
         ;; A person who sees the simulation alone moves no real arm by it, unless told to.
         (real (or own-cameras (section-in arm-parts 'driver) (section-in arm-parts 'plugin)))
         (agent-nodes (sections-in found 'agent))
         (agents (scheme-agents-of agent-nodes))
         (hosts (hosts-of named-hosts
                          (append (if has-unit '() '(pan-tilt)) (if real simulated-kinds '()))
                          (map first agents)))
         (board (board-of found hosts))
         (cubes (cubes-of (sections-in things 'cube) size))
         (tagged (tagged-of found)))
    (refuse-idle agent-nodes agents hosts)
    (unless has-unit
      (refuse-agent named-hosts 'pan-tilt
                    "the cell has no pan-tilt unit: neither (camera (head UNIT)) nor (pan-tilt LINE) is given"))
    (unless has-unit (refuse-axes found))
    (unless slave
      (for-each (lambda (kind) (refuse-agent named-hosts kind "there is no second arm: (slave ARM) is not given"))
                '(slave follower)))
    (when own-cameras
      (refuse-agent named-hosts 'person "the person is simulated, and sees nothing through the cell's own cameras"))
    `((name ,name)
      (camera ,camera)
      (noise ,(noise-of things))
      (cubes ,cubes)
      (arm ,(or (and arm (arm-of arm arms)) 'crs-f3))
      (domain ,(text-of-section found 'domain "the domain's file" ""))
      (board-host ,(first board))
      (board-address ,(second board))
      (hosts ,hosts)
      (cube-size ,size)
      (openings ,(openings-of things size))
      (row ,(row-of things))
      (board-keys ,(third board))
      (pan-tilt ,pan-tilt)
      (room ,(room-of arm-parts))
      (driver ,(driver-of arm-parts))
      (objects ,(text-of-section found 'objects "the folder of the objects" ""))
      (eyes ,(if own-cameras (camera-of-section own-cameras) '()))
      (slave ,(if slave (slave-of (node-within slave "in the second arm") arms) '()))
      (gripper ,(gripper-of arm-parts))
      (rate ,(rate-of arm-parts))
      (agents ,agents)
      (tags ,(tags-of found))
      (door ,(door-of found (third board)))
      (camera-pose ,(believed-camera-of found))
      (lamp ,(lamp-of things))
      (tagged ,tagged)
      (background ,(picture-of things 'background))
      (table-picture ,(picture-of things 'table-picture))
      (lens ,(lens-of things))
      (bodies ,(bodies-of found tagged))
      (things ,(things-of
                (filter-map (lambda (section) (and (memq (car section) '(brick cylinder)) (cdr section))) things)
                cubes)))))

;; ARMS are the names of the arms that come with the tree.
(define* (interpret data #:optional (arms '(crs-f3)))
  (interpreting data
    (lambda (root)
      (let* ((cell (only-form root 'cell))
             (name (and cell (plain-name-at cell 1 "the cell's name"))))
        (and name
             (interpret-sections (node-within cell (string-append "in cell " (symbol->string name))) name arms))))))
