;; Arm files: see drivers/arm/arm_file.hpp for the language.
;;
;; (interpret DATA), the data of a file, answers (errors ...) or
;;   (ok (NAME STRUCTURE (HEIGHT OFFSET UPPER-ARM FOREARM RAISE WRIST TOOL SIDE ACROSS)
;;        ((ROLE LOW HIGH SPEED SENSE ZERO FROM (STOP-LOW STOP-HIGH) PULSES-PER-TURN ALONG) ...) (HOME ...) (READY ...)))
;; in mm and degrees whatever the file's units are; an axis without stops has the empty list there.

(define-module (pizarra arm)
  #:use-module (srfi srfi-1)
  #:use-module (pizarra forms)
  #:export (interpret))

(define most-axes 8)
(define lengths '(height offset upper-arm forearm raise wrist tool side across))

;; STRUCTURE, the roles of its own axes, the lengths it has, and those of them that it cannot be without.
(define structures
  '((articulated (turn shoulder elbow) (height offset upper-arm forearm raise wrist tool side across) (upper-arm forearm))
    (polar (turn shoulder reach) (height offset wrist tool) ())
    (scara (turn elbow lift) (height upper-arm forearm wrist tool) (upper-arm forearm))
    (gantry (ahead across lift) (height wrist tool) ())))
(define (roles-of structure) (second (assq structure structures)))

(define wrists '((spin) (pitch spin) (roll pitch spin)))
(define sliding '(reach lift ahead across track))

(define length-units '((mm . 1) (cm . 10) (m . 1000) (in . 25.4)))
(define angle-units `((deg . 1) (rad . ,(/ 180 (acos -1)))))

(define longest-mm 10000)
(define largest 1e6)

;; ---- units: (MM-PER-UNIT . DEGREES-PER-UNIT)

(define (unit-at node index what units)
  (let ((name (symbol-at node index what)))
    (and name
         (or (assq-ref units name)
             (complain! (node-ref node index) 'unknown-name "~a cannot be ~a~a" what name
                        (suggestion name (map car units)))))))

(define (units-of found)
  (let ((node (section-in found 'units)))
    (cons (or (and node (unit-at node 1 "the unit of lengths" length-units)) 1)
          (or (and node (unit-at node 2 "the unit of angles" angle-units)) 1))))

(define (unit-for role units)
  (if (memq role sliding) (car units) (cdr units)))

;; ---- the numbers of a section

(define (one-number found name range otherwise)
  (let ((node (section-in found name)))
    (or (and node (let ((numbers (numbers-of node (list range)))) (and numbers (first numbers)))) otherwise)))

(define (pair-of node unit)
  (let ((pair (numbers-of node (list (list (- largest) largest) (list (- largest) largest)))))
    (and pair
         (if (< (first pair) (second pair))
             (map (lambda (number) (* unit number)) pair)
             (complain! node 'malformed "the lower limit comes first, and is below the upper")))))

;; ---- links

(define (lengths-of node structure units)
  (let* ((known (third (assq structure structures)))
         (found (sections (node-rest node) known))
         (longest (/ longest-mm (car units))))
    (for-each (lambda (name)
                (unless (section-in found name)
                  (complain! node 'malformed "the length (~a ...) is missing" name)))
              (fourth (assq structure structures)))
    (map (lambda (name)
           (let ((low (if (memq name '(upper-arm forearm)) (/ 1 (car units)) 0)))
             (* (car units)
                (one-number found name (list (if (memq name '(height offset raise side across)) (- longest) low) longest) 0))))
         lengths)))

;; ---- axes

(define (word-in found name what choices otherwise)
  (let* ((node (section-in found name))
         (word (and node (symbol-at node 1 what))))
    (cond ((not word) otherwise)
          ((memq word choices) word)
          (else (complain! (node-ref node 1) 'unknown-name "~a cannot be ~a~a" what word (suggestion word choices))
                otherwise))))

(define (sense-of found)
  (let ((sense (one-number found 'sense '(-1 1) 1)))
    (if (= (abs sense) 1)
        sense
        (begin (complain! (section-in found 'sense) 'malformed "the sense is 1 or -1") 1))))

;; The parts that only some axes have.
(define (allowed-in role structure)
  (append '(limits speed sense zero pulses-per-turn)
          (if (and (memq structure '(articulated polar)) (memq role '(elbow pitch))) '(from stops) '())
          (if (eq? role 'track) '(along) '())))

(define (axis-of node structure units)
  (let ((role (and (node-form? node 'axis) (symbol-at node 1 "the axis' part"))))
    (and role
         (let* ((inside (node-within node (string-append "in axis " (symbol->string role))))
                (found (sections (drop (node-items inside) 2) (allowed-in role structure)))
                (unit (unit-for role units))
                (limits (section-in found 'limits))
                (pair (if limits (pair-of limits unit) (complain! inside 'malformed "the axis has no (limits LOW HIGH)")))
                (speed (one-number found 'speed (list 0.001 largest) #f))
                (stops (section-in found 'stops)))
           (unless (section-in found 'speed) (complain! inside 'malformed "the axis has no (speed S)"))
           (when (and stops (not (section-in found 'from)))
             (complain! stops 'malformed "only an axis that a linkage holds, (from base), has (stops LOW HIGH)"))
           (and pair speed
                (list role (first pair) (second pair) (* unit speed)
                      (sense-of found)
                      (* unit (one-number found 'zero (list (- largest) largest) 0))
                      (word-in found 'from "what an axis is counted from" '(link base) 'link)
                      (or (and stops (pair-of stops unit)) '())
                      (one-number found 'pulses-per-turn '(1 1e9) 0)
                      (word-in found 'along "where a track runs" '(x y) 'y)))))))

;; The roles of the structure, then of a wrist, each once; a track anywhere.
(define (check-roles nodes structure)
  (let* ((role-of (lambda (node) (let ((role (node-ref node 1))) (and role (node-datum role)))))
         (roles (filter-map role-of nodes))
         (known (append (roles-of structure) '(roll pitch spin track))))
    (refuse-repeated nodes role-of "an axis for")
    (for-each (lambda (node)
                (let ((role (role-of node)))
                  (when (and (symbol? role) (not (memq role known)))
                    (complain! (node-ref node 1) 'unknown-name "the arm has no axis ~a~a" role (suggestion role known)))))
              nodes)
    (let ((missing (lset-difference eq? (roles-of structure) roles)))
      (unless (or (null? nodes) (null? missing))
        (complain! (first nodes) 'malformed "the axis ~a is missing" (first missing))))
    (let ((wrist (filter (lambda (role) (memq role '(roll pitch spin))) roles)))
      (unless (or (null? nodes) (any (lambda (known) (lset= eq? known wrist)) wrists))
        (complain! (first nodes) 'malformed
                   "the axes of a wrist are spin alone, pitch and spin, or roll, pitch and spin")))))

;; Links beside axis 1, or a tool beside its pitch axis, ask for a wrist that stays in the links' plane.
(define (check-beside node axes sizes)
  (when (and (assq 'roll axes) (not (every zero? (list-tail sizes 7))))
    (complain! node 'malformed "only an arm without an axis of roll has (side ...) and (across ...)")))

;; With an axis of roll before it, the tool's elevation is not the pitch axis' alone.
(define (check-coupling nodes axes)
  (let ((pitch (assq 'pitch axes)))
    (when (and pitch (assq 'roll axes) (eq? (seventh pitch) 'base))
      (complain! (find (lambda (node) (eq? (node-datum (node-ref node 1)) 'pitch)) nodes)
                 'malformed "an axis of pitch behind one of roll cannot be counted from the base"))))

(define (axes-of nodes structure units)
  (let* ((nodes (at-most nodes most-axes "axes"))
         (axes (filter-map (lambda (node) (axis-of node structure units)) nodes)))
    (check-roles nodes structure)
    (check-coupling nodes axes)
    axes))

;; ---- poses

(define (pose-of found name axes units inside)
  (let ((node (section-in found name)))
    (if (not node)
        (complain! inside 'malformed "there is no pose (~a ...)" name)
        (let* ((slack 1e-9)
               (scales (map (lambda (axis) (unit-for (first axis) units)) axes))
               (ranges (map (lambda (axis scale)
                              (list (- (/ (second axis) scale) slack) (+ (/ (third axis) scale) slack)))
                            axes scales))
               (pose (numbers-of node ranges)))
          (and pose (map * scales pose))))))

;; ----

(define (interpret-links arm name found links)
  (let* ((structure (node-head links))
         (units (units-of found))
         (sizes (lengths-of links structure units))
         (nodes (sections-in found 'axis))
         (axes (axes-of nodes structure units))
         (sound? (= (length axes) (length nodes))))
    (check-beside links axes sizes)
    (list name structure sizes axes
          (if sound? (pose-of found 'home axes units arm) '())
          (if sound? (pose-of found 'ready axes units arm) '()))))

(define (interpret-sections arm name)
  (let* ((kinds (map first structures))
         (found (sections (drop (node-items arm) 2) (append '(units axis home ready) kinds) '(axis)))
         (builds (filter-map (lambda (entry) (and (memq (car entry) kinds) (cdr entry))) found)))
    (cond ((null? builds) (complain! arm 'malformed "the arm's build is missing~a" (suggestion #f kinds)))
          ((pair? (cdr builds))
           (complain! (second builds) 'repeated "an arm has one build, and this one is ~a already"
                      (node-head (first builds))))
          (else (interpret-links arm name found (node-within (first builds) "in the links"))))))

(define (interpret data)
  (interpreting data
    (lambda (root)
      (let* ((arm (only-form root 'arm))
             (name (and arm (symbol-at arm 1 "the arm's name"))))
        (and name
             (interpret-sections (node-within arm (string-append "in arm " (symbol->string name))) name))))))
