;; Cell files: see lisp/forms/cell_file.hpp for the language and for what is taken where something is left out.
;;
;; (interpret DATA), the data of a file, answers (errors ...) or
;;   (ok (NAME (X Y Z PAN TILT ROLL HEAD FRAMES AXES) (SENSOR BLUR GRADIENT) (CUBE ...) ARM DOMAIN BOARD-HOST BOARD-ADDRESS
;;        ((HOST KEY KIND ...) ...) CUBE-SIZE (NARROW NORMAL WIDE) (ROW-X ROW-Y-LOW ROW-Y-HIGH) BOARD-KEYS
;;        (LINE WHERE NUMBER (REVERSED ...)) ROOM DRIVER OBJECTS CAMERA SLAVE GRIPPER RATE
;;        ((AGENT FILE MILLISECONDS MEGABYTES MESSAGES KEY) ...) ((FAMILY SIDE) ...) DOOR CAMERA-POSE))
;; with CUBE = (NAME MARK X Y YAW ON), ON the empty string for the table; KEY and BOARD-KEYS are paths or empty; HEAD the
;; simulated pan-tilt unit under the cameras or the empty string; FRAMES how many a second they take; LINE serial, tcp or
;; the empty string, how the unit of the agent is reached, NUMBER a baud rate or a port; ROOM that of the arm, or (); DRIVER how its controller is reached,
;; (PROTOCOL (PLACE ...) (NUMBER ...)), or () for the simulated arm;
;; OBJECTS the folder of the object database, or empty; CAMERA what (pizarra camera) makes of the cameras of the
;; agent, or () for the simulated ones; SLAVE the second arm, (ARM ROOM DRIVER (X Y Z) plain|mirror GRIPPER RATE), or ();
;; GRIPPER what (pizarra gripper) makes of the arm's, or () for its own; RATE how
;; often a second the arm tells its state; then the agents that are Scheme files, and the tags that the eyes look for;
;; DOOR is the text door, (PORT ((FILE BAUD) ...) KEYS), PORT -1 where it has none over TCP, or () where the cell has no
;; door; CAMERA-POSE is what (pizarra camera-pose) makes of where the agents take the camera to be, as AXES, those of the
;; simulated unit, are.

(define-module (pizarra cell)
  #:use-module (srfi srfi-1)
  #:use-module (pizarra forms)
  #:use-module (pizarra camera)
  #:use-module (pizarra camera-pose)
  #:use-module (pizarra driver)
  #:use-module (pizarra gripper)
  #:use-module (pizarra tags)
  #:export (interpret cubes-of))

(define marks '(circle triangle square cross))
(define kinds '(robot vision pan-tilt planner coordinator person))
;; Sees and points through the simulation alone.
(define simulated-kinds '(person))
;; Those that a cell has only where it says so.
(define further-kinds '(speech slave follower))
(define known-kinds (append kinds further-kinds))
;; What `up` runs beside the agents; each has a log of its name, and is on the board under it.
(define processes '(board world log door console arm-plugin camera-plugin narrator))
(define heads '(ptu46-17.5 ptu46-70))
;; Each takes a whole number of the world's steps.
(define frame-rates '(10 20 30 40 60))
(define baud-rates '(9600 19200 38400 57600 115200))
;; Smaller marks are not recognised, and the fingers do not open wider.
(define cube-sizes-mm '(40 64))
(define most-opening-mm 100)
(define most-cubes 16)

;; Where a cube on the table can be seen and reached.
(define reach-mm '((250 650) (-350 350)))

;; Letters, digits and dashes, a letter first: what can name an object, a fact's argument and a file alike.
(define (plain-name? text)
  (and (<= 1 (string-length text) 64)
       (char-set-contains? char-set:letter (string-ref text 0))
       (string-every (char-set-union char-set:letter char-set:digit (char-set #\-)) text)))

(define (plain-name-at node index what)
  (let ((name (symbol-at node index what)))
    (and name
         (or (and (plain-name? (symbol->string name)) name)
             (complain! (node-ref node index) 'malformed "~a has letters, digits and dashes" what)))))

;; ---- cubes

(define (cube-name cube) (first cube))
(define (cube-x cube) (third cube))
(define (cube-y cube) (fourth cube))
(define (cube-on cube) (sixth cube))
(define (cube-edge cube) (seventh cube))

(define (on-table? cube) (string? (cube-on cube)))

(define (overlap? a b)
  (and (on-table? a) (on-table? b)
       (< (max (abs (- (cube-x a) (cube-x b))) (abs (- (cube-y a) (cube-y b))))
          (/ (+ (cube-edge a) (cube-edge b)) 2))))

;; Where it stands, (X Y ON), on the cube that (on NAME) names.
(define (place-on node known)
  (let* ((name (symbol-at node 1 "the cube below"))
         (below (and name (assq name known))))
    (cond ((not name) #f)
          ((not below)
           (complain! node 'unknown-object "no cube ~a stands before this one~a" name
                      (suggestion name (map cube-name known))))
          ((any (lambda (cube) (eq? (cube-on cube) name)) known)
           (complain! node 'occupied "another cube stands on ~a already" name))
          (else (list (cube-x below) (cube-y below) name)))))

(define (cube-place node found known)
  (let ((at (section-in found 'at)) (on (section-in found 'on)))
    (cond ((and at on) (complain! on 'repeated "a cube stands either at a place or on a cube"))
          (at (let ((place (numbers-of at reach-mm))) (and place (append place '("")))))
          (on (place-on on known))
          (else (complain! node 'malformed "the cube has no place: (at X Y) or (on CUBE)")))))

(define (cube-mark node found name)
  (let ((mark (section-in found 'mark)))
    (cond (mark (choice-at mark 1 "a mark" marks))
          ((memq name marks) name)
          (else (complain! node 'malformed "the cube ~a needs a (mark ...)~a" name (suggestion #f marks))))))

(define (refuse-collisions cube node known)
  (for-each (lambda (other)
              (when (same-name? (cube-name cube) (cube-name other))
                (complain! node 'repeated "there is a cube ~a already" (cube-name other)))
              (when (overlap? cube other)
                (complain! node 'overlap "~a and ~a stand in one place" (cube-name cube) (cube-name other))))
            known))

;; The cube that NODE describes, which stands after those of KNOWN, or #f.
(define (cube-of node known size)
  (let ((name (and (node-form? node 'cube) (plain-name-at node 1 "the cube's name"))))
    (and name
         (let* ((inside (node-within node (string-append "in cube " (symbol->string name))))
                (found (sections (drop (node-items inside) 2) '(at on yaw mark size)))
                (mark (cube-mark inside found name))
                (place (cube-place inside found known))
                (yaw (numbers-in found 'yaw '((-180 180)) '(0)))
                ;; A place for the cell's cubes has room for smaller ones.
                (edge (numbers-in found 'size (list (list (first cube-sizes-mm) size)) (list size))))
           (and mark place
                (let ((cube (list name mark (first place) (second place) (first yaw) (third place) (first edge))))
                  (refuse-collisions cube node known)
                  cube))))))

(define (cubes-of nodes size)
  (when (> (length nodes) most-cubes)
    (complain! (list-ref nodes most-cubes) 'too-many "a cell has at most ~a cubes" most-cubes))
  (reverse
   (fold (lambda (node known)
           (let ((cube (cube-of node known size)))
             (if cube (cons cube known) known)))
         '() nodes)))

;; ---- what the cubes' size asks of gripper and table

(define (cube-size-of found)
  (first (numbers-in found 'cube-size (list cube-sizes-mm) '(60))))

;; Narrow, normal and wide, in this order.
(define (openings-of found size)
  (let* ((node (section-in found 'openings))
         (range (list (+ size 2) most-opening-mm))
         (openings (numbers-in found 'openings (list range range range)
                               (map (lambda (room) (+ size room)) '(16 24 36)))))
    (when (and node (not (apply <= openings)))
      (complain! node 'malformed "the openings are (openings NARROW NORMAL WIDE), none smaller than the one before"))
    openings))

;; The x of the row that cubes are put down in, and its ends.
(define (row-of found)
  (let* ((node (section-in found 'row))
         (parts (if node (sections (node-rest (node-within node "in the row")) '(x y)) '()))
         (x (numbers-in parts 'x (list (first reach-mm)) '(450)))
         (y (numbers-in parts 'y (list (second reach-mm) (second reach-mm)) '(-200 200))))
    (when (> (first y) (second y))
      (complain! (section-in parts 'y) 'malformed "the row is (y LOW HIGH), its low end first"))
    (append x y)))

;; ---- camera and noise

(define (camera-of found)
  (let* ((camera (section-in found 'camera))
         (parts (if camera
                    (sections (node-rest (node-within camera "in the camera")) '(at pan tilt roll head rate))
                    '()))
         (head (section-in parts 'head)))
    (append (pose-of parts)
            (list (if head (or (choice-at head 1 "the pan-tilt unit" heads) "") "")
                  (frame-rate-of parts)
                  (if (and head (> (length (node-items head)) 2)) (axes-of head (drop (node-items head) 2)) '())))))

(define (frame-rate-of parts)
  (let ((rate (first (numbers-in parts 'rate '((10 60)) '(10)))))
    (if (memv rate frame-rates)
        rate
        (complain! (section-in parts 'rate) 'out-of-range
                   "the simulated cameras take 10, 20, 30, 40 or 60 frames a second"))))

;; Where the agents take the camera to be.
(define (believed-camera-of found world-camera)
  (let ((section (section-in found 'camera-pose)))
    (if section
        (camera-pose-of-section section '(at pan tilt roll sure mark head file))
        (standing-as (take world-camera 6) (last world-camera)))))

;; A camera that stands still turns about nothing.
(define (refuse-axes found)
  (let* ((section (section-in found 'camera-pose))
         (head (and section (find (lambda (item) (eq? (node-head item) 'head)) (node-rest section)))))
    (when head
      (complain! head 'malformed "there is nothing to turn: neither (camera (head UNIT)) nor (pan-tilt LINE) is given"))))

;; ---- the pan-tilt unit of the agent, where it is not the simulated one

;; (serial PATH [BAUD]) or (tcp HOST PORT), as (LINE WHERE NUMBER).
(define (line-of node)
  (let* ((name (node-head node))
         (line (and (memq name '(serial tcp)) name))
         (where (and line (string-at node 1 (if (eq? line 'serial) "the line's file" "the unit's address"))))
         (number (cond ((not line) #f)
                       ((and (eq? line 'serial) (= (length (node-items node)) 2)) 9600)
                       (else (integer-at node 2 (if (eq? line 'serial) "the baud rate" "the port"))))))
    (cond ((not line)
           (complain! node 'malformed "the pan-tilt unit is at (serial FILE BAUD) or (tcp HOST PORT)"))
          ((and (eq? line 'serial) number (not (memv number baud-rates)))
           (complain! (node-ref node 2) 'out-of-range "serial lines run at 9600, 19200, 38400, 57600 or 115200 baud"))
          ((and (eq? line 'tcp) number (not (<= 1 number 65535)))
           (complain! (node-ref node 2) 'out-of-range "a port is a number from 1 to 65535"))
          (else (and where number (list line where number))))))

(define (axis-of node)
  (let ((axis (symbol-of node "an axis")))
    (and axis
         (or (find (lambda (known) (eq? known axis)) '(pan tilt))
             (complain! node 'unknown-name "the axes are pan and tilt")))))

;; (pan-tilt LINE (reversed AXIS ...)) as (LINE WHERE NUMBER (AXIS ...)).
(define (pan-tilt-of found)
  (let ((unit (section-in found 'pan-tilt)))
    (if (not unit)
        (list "" "" 0 '())
        (let* ((inside (node-within unit "in the pan-tilt unit"))
               (line (and (pair? (node-rest inside)) (line-of (node-ref inside 1))))
               (others (if (pair? (node-rest inside))
                           (sections (cdr (node-rest inside)) '(reversed))
                           (complain! inside 'malformed "the pan-tilt unit is at (serial FILE BAUD) or (tcp HOST PORT)")))
               (reversed (and others (section-in others 'reversed))))
          (append (or line (list "" "" 0))
                  (list (if reversed (filter-map axis-of (node-rest reversed)) '())))))))

(define (noise-of found)
  (let* ((noise (section-in found 'noise))
         (parts (if noise (sections (node-rest (node-within noise "in the noise")) '(sensor blur gradient)) '())))
    (append (numbers-in parts 'sensor '((0 20)) '(3))
            (numbers-in parts 'blur '((0 2)) '(0.7))
            (numbers-in parts 'gradient '((0 0.9)) '(0.12)))))

;; ---- hosts and the board

;; A host's name is part of a folder's name.
(define (host-name? text)
  (and (<= 1 (string-length text) 64)
       (char-set-contains? char-set:letter+digit (string-ref text 0))
       (string-every (char-set-union char-set:letter+digit (char-set #\- #\.)) text)))

(define (host-at node index)
  (let ((name (string-at node index "the host's name")))
    (and name
         (or (and (host-name? name) name)
             (complain! (node-ref node index) 'malformed "a host's name has letters, digits, dashes and dots")))))

;; Another of a kind is called KIND-NUMBER, as vision-2.
(define (kind-of-agent name)
  (let* ((text (symbol->string name))
         (dash (string-rindex text #\-))
         (number (if dash (substring text (+ dash 1)) "")))
    (if (and (positive? (string-length number)) (string-every char-set:digit number))
        (string->symbol (substring text 0 dash))
        name)))

(define (agent-of node added)
  (let ((name (symbol-of node "an agent")))
    (and name
         (if (or (memq name added) (memq (kind-of-agent name) known-kinds))
             name
             (complain! node 'unknown-agent "there is no agent ~a~a" name
                        (suggestion name (append known-kinds added)))))))

;; The parts of a named host: (KEY AGENT-NODE ...), KEY the file of the secret with which it comes to a board elsewhere.
(define (things-of-host host)
  (let* ((found (sections (drop (node-items host) 2) '(agents key)))
         (agents (section-in found 'agents)))
    (cons (text-of-section found 'key "the file of the host's key" "")
          (if agents (node-rest agents) '()))))

;; ADDED are the agents that are Scheme files.
(define (hosts-of nodes missing added)
  (if (null? nodes)
      (list (cons* "localhost" "" (append (lset-difference eq? kinds missing) added)))
      (let* ((named (filter (lambda (node) (host-at node 1)) nodes))
             (things (map things-of-host named)))
        (refuse-repeated named (lambda (node) (node-datum (node-ref node 1))) "a host")
        (refuse-repeated (append-map cdr things) node-datum "a host for the agent")
        (map (lambda (node things-of-it)
               (cons* (node-datum (node-ref node 1)) (car things-of-it)
                      (filter-map (lambda (agent) (agent-of agent added)) (cdr things-of-it))))
             named things))))

;; (agent NAME (scheme "FILE") (time MS) (memory MB) (rate N) (key "FILE")) as (NAME FILE MS MB N KEY), or #f.
(define (scheme-agent-of node)
  (let* ((name (plain-name-at node 1 "the agent's name"))
         (inside (node-within node (if name (string-append "in agent " (symbol->string name)) "in an agent")))
         (found (sections (let ((rest (node-rest inside))) (if (pair? rest) (cdr rest) '()))
                          '(scheme time memory rate key)))
         (file (section-in found 'scheme)))
    (when (and name (memq (kind-of-agent name) known-kinds))
      (complain! (node-ref node 1) 'repeated "the cell has an agent ~a of its own: take another name" name))
    (when (memq name processes)
      (complain! (node-ref node 1) 'repeated "~a is a process that `up` runs by itself: take another name" name))
    (unless file
      (complain-missing! inside '(scheme) "the agent needs its file: (scheme \"FILE\")"))
    (and name file
         (list name
               (or (string-at file 1 "the agent's file") "")
               (first (numbers-in found 'time '((10 60000)) '(1000)))
               (first (numbers-in found 'memory '((8 4096)) '(64)))
               (first (numbers-in found 'rate '((1 100000)) '(1000)))
               (text-of-section found 'key "the file of the agent's key" "")))))

(define (scheme-agents-of nodes)
  (refuse-repeated nodes (lambda (node) (let ((name (node-ref node 1))) (and name (node-datum name)))) "an agent")
  (filter-map scheme-agent-of (at-most nodes 16 "agents that are Scheme files")))

;; Complains about those that no host runs.
(define (refuse-idle nodes agents hosts)
  (for-each (lambda (agent)
              (unless (any (lambda (host) (memq (car agent) (cddr host))) hosts)
                (complain! (find (lambda (node) (eq? (node-datum (node-ref node 1)) (car agent))) nodes)
                           'unknown-agent "no host runs ~a: name it in a host's (agents ...)" (car agent))))
            agents))

;; Complains about every host's agent of this kind, which the cell has nothing for.
(define (refuse-agent hosts refused sentence)
  (for-each (lambda (host)
              (let* ((agents (find (lambda (item) (eq? (node-head item) 'agents)) (node-rest host)))
                     (node (and agents
                              (find (lambda (agent)
                                      (and (symbol? (node-datum agent)) (eq? (kind-of-agent (node-datum agent)) refused)))
                                    (node-rest agents)))))
                (when node (complain! node 'unknown-agent sentence))))
            hosts))

;; (HOST ADDRESS KEYS), KEYS the folder of the keys that may come.
(define (board-of found hosts)
  (let ((board (section-in found 'board)))
    (if board
        (list (or (host-at board 1) "")
              (or (string-at board 2 "the board's address") "")
              (if (> (length (node-items board)) 3)
                  (text-of-section (sections (drop (node-items board) 3) '(keys)) 'keys "the folder of the keys" "")
                  ""))
        (list (if (null? hosts) "localhost" (car (first hosts))) "" ""))))

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

;; ---- the text door

(define door-baud 115200)

(define (door-port-of found)
  (let ((tcp (section-in found 'tcp)))
    (if (not tcp)
        -1
        (let ((port (integer-at tcp 1 "the port")))
          (cond ((not port) -1)
                ((not (<= 0 port 65535)) (complain! (node-ref tcp 1) 'out-of-range "a port is a number from 0 to 65535") -1)
                ((> (length (node-items tcp)) 2) (complain! (node-ref tcp 2) 'malformed "(tcp PORT) takes one port") -1)
                (else port))))))

(define (door-line-of node)
  (let* ((file (string-at node 1 "the line's file"))
         (given (length (node-items node)))
         (baud (if (= given 2) door-baud (integer-at node 2 "the baud rate"))))
    (cond ((not (and file baud)) #f)
          ((not (string-prefix? "/dev/" file)) (complain! (node-ref node 1) 'malformed "a serial line is a file of /dev/"))
          ((not (memv baud baud-rates))
           (complain! (node-ref node 2) 'out-of-range "serial lines run at 9600, 19200, 38400, 57600 or 115200 baud"))
          ((> given 3) (complain! (node-ref node 3) 'malformed "(serial FILE BAUD) takes no more"))
          (else (list file baud)))))

;; BOARD-KEYS are taken where the door names no folder.
(define (door-of found board-keys)
  (let ((door (section-in found 'door)))
    (if (not door)
        '()
        (let* ((parts (sections (node-rest (node-within door "in the door")) '(tcp serial keys) '(serial)))
               (port (door-port-of parts))
               (lines (filter-map door-line-of (at-most (sections-in parts 'serial) 16 "serial lines")))
               (keys (text-of-section parts 'keys "the folder of the devices' keys" board-keys)))
          (unless (or (section-in parts 'tcp) (pair? (sections-in parts 'serial)))
            (complain! door 'malformed "the door is reached at (tcp PORT) or (serial FILE BAUD)"))
          (when (string-null? keys)
            (complain! door 'malformed "the door needs the folder of its devices' keys: (keys \"DIR\")"))
          (list port lines keys)))))

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
                        (complain! (section-in parts name) 'malformed "a span has its low end first"))
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
  (let* ((found (sections (drop (node-items cell) 2) '(world arm slave camera camera-pose tags pan-tilt objects domain board
                                                          agent host door)
                          '(agent host)))
         (world (section-in found 'world))
         (things (if world
                     (sections (node-rest (node-within world "in the world"))
                               '(camera cube cube-size noise openings row) '(cube))
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
         (board (board-of found hosts)))
    (refuse-idle agent-nodes agents hosts)
    (unless has-unit
      (refuse-agent named-hosts 'pan-tilt
                    "there is nothing to turn: neither (camera (head UNIT)) nor (pan-tilt LINE) is given"))
    (unless has-unit (refuse-axes found))
    (unless slave
      (for-each (lambda (kind) (refuse-agent named-hosts kind "there is no second arm: (slave ARM) is not given"))
                '(slave follower)))
    (when own-cameras
      (refuse-agent named-hosts 'person "the person is simulated, and sees nothing through the cell's own cameras"))
    (list name
          camera
          (noise-of things)
          (cubes-of (sections-in things 'cube) size)
          (or (and arm (arm-of arm arms)) 'crs-f3)
          (text-of-section found 'domain "the domain's file" "")
          (first board)
          (second board)
          hosts
          size
          (openings-of things size)
          (row-of things)
          (third board)
          pan-tilt
          (room-of arm-parts)
          (driver-of arm-parts)
          (text-of-section found 'objects "the folder of the objects" "")
          (if own-cameras (camera-of-section own-cameras) '())
          (if slave (slave-of (node-within slave "in the second arm") arms) '())
          (gripper-of arm-parts)
          (rate-of arm-parts)
          agents
          (tags-of found)
          (door-of found (third board))
          (believed-camera-of found camera))))

;; ARMS are the names of the arms that come with the tree.
(define* (interpret data #:optional (arms '(crs-f3)))
  (interpreting data
    (lambda (root)
      (let* ((cell (only-form root 'cell))
             (name (and cell (plain-name-at cell 1 "the cell's name"))))
        (and name
             (interpret-sections (node-within cell (string-append "in cell " (symbol->string name))) name arms))))))
