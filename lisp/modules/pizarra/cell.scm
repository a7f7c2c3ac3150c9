;;; Cell files: see lisp/cell.hpp for the language and the values that are left out.
;;;
;;; (interpret-cell DATA), the data of a file, answers
;;;   (cell NAME (X Y Z PAN TILT) (SENSOR BLUR GRADIENT) (CUBE ...) ARM DOMAIN BOARD-HOST BOARD-ADDRESS
;;;         ((HOST KIND ...) ...))
;;; with CUBE = (NAME MARK X Y YAW ON), ON the empty string for the table; or (errors ...).

(define-module (pizarra cell)
  #:use-module (srfi srfi-1)
  #:use-module (pizarra sections)
  #:export (interpret-cell interpret-cubes))

(define marks '(circle triangle square cross))
(define kinds '(robot vision planner coordinator person))
(define cube-size-mm 60)

;; Where the table can be seen and reached.
(define x-range-mm '(250 700))
(define y-range-mm '(-350 350))

;; --- cubes

(define (cube-name cube) (first cube))
(define (cube-x cube) (third cube))
(define (cube-y cube) (fourth cube))
(define (cube-on cube) (sixth cube))

(define (overlap? a b)
  (and (string? (cube-on a)) (string? (cube-on b))
       (< (max (abs (- (cube-x a) (cube-x b))) (abs (- (cube-y a) (cube-y b)))) cube-size-mm)))

;; Where a cube stands: (X Y ON) from its (at X Y) or (on NAME).
(define (cube-place form path known)
  (let ((at (section form path 'at)) (on (section form path 'on)))
    (cond ((and at on)
           (problem! 'twice "a cube is either at a place or on another cube" (section-path on))
           #f)
          (at (let ((values (section-numbers at 2 (list x-range-mm y-range-mm))))
                (and values (append values '("")))))
          (on (let* ((name (section-name on))
                     (below (and name (assq name known))))
                (cond ((not name) #f)
                      ((not below)
                       (problem! 'unknown-cube
                                 (string-append "no cube named " (symbol->string name) " stands before this one")
                                 (section-path on))
                       #f)
                      ((any (lambda (cube) (eq? (cube-on cube) name)) known)
                       (problem! 'occupied
                                 (string-append "another cube stands on " (symbol->string name) " already")
                                 (section-path on))
                       #f)
                      (else (list (cube-x below) (cube-y below) name)))))
          (else (problem! 'missing "the cube has no place: give (at X Y) or (on CUBE)" path) #f))))

(define (cube-mark form path name)
  (let ((mark (section form path 'mark)))
    (cond (mark (section-choice mark marks))
          ((memq name marks) name)
          (else
           (problem! 'missing
                     (string-append "the cube needs a (mark ...), one of " (names->string marks))
                     path)
           #f))))

;; One (cube NAME CLAUSE ...) after those of `known`, or #f after telling what is wrong.
(define (interpret-cube form path known)
  (let ((name (form-name form path)))
    (check-sections form path 2 '(at on yaw mark))
    (and name
         (let ((yaw (section form path 'yaw))
               (mark (cube-mark form path name))
               (place (cube-place form path known)))
           (when (assq name known)
             (problem! 'twice (string-append "a cube named " (symbol->string name) " stands before this one")
                       (append path '(1))))
           (let ((degrees (if yaw (section-numbers yaw 1 '((-180 180))) '(0))))
             (and place mark degrees
                  (let ((cube (list name mark (first place) (second place) (first degrees) (third place))))
                    (for-each (lambda (other)
                                (when (overlap? cube other)
                                  (problem! 'overlap
                                            (string-append "stands in the cube "
                                                           (symbol->string (cube-name other)))
                                            path)))
                              known)
                    cube)))))))

;; FORMS is a list of (FORM . PATH), each a (cube ...).
(define (interpret-cubes forms)
  (reverse
   (fold (lambda (form+path known)
           (let ((cube (interpret-cube (car form+path) (cdr form+path) known)))
             (if cube (cons cube known) known)))
         '() forms)))

;; --- the world, hosts and the rest

(define (interpret-camera world path)
  (let ((camera (and world (section world path 'camera))))
    (if (not camera)
        '(1330 0 200 0 0)
        (let* ((form (section-form camera)) (where (section-path camera)))
          (check-sections form where 1 '(at pan tilt))
          (let ((at (section form where 'at))
                (pan (section form where 'pan))
                (tilt (section form where 'tilt)))
            (append (or (and at (section-numbers at 3 '((600 3000) (-2000 2000) (20 2000)))) '(1330 0 200))
                    (or (and pan (section-numbers pan 1 '((-60 60)))) '(0))
                    (or (and tilt (section-numbers tilt 1 '((-60 60)))) '(0))))))))

(define (interpret-noise world path)
  (let ((noise (and world (section world path 'noise))))
    (if (not noise)
        '(3 0.7 0.12)
        (let* ((form (section-form noise)) (where (section-path noise)))
          (check-sections form where 1 '(sensor blur gradient))
          (map (lambda (name otherwise range)
                 (let* ((found (section form where name))
                        (values (and found (section-numbers found 1 (list range)))))
                   (if values (first values) otherwise)))
               '(sensor blur gradient) '(3 0.7 0.12) '((0 20) (0 3) (0 0.9)))))))

(define (interpret-host host taken)
  (let* ((form (section-form host)) (path (section-path host)) (name (form-string form path)))
    (check-sections form path 2 '(agents))
    (let ((agents (section form path 'agents)))
      (and name
           (cons name
                 (if agents
                     (let ((where (section-path agents)))
                       (filter-map
                        (lambda (kind index)
                          (let ((here (append where (list index))))
                            (cond ((not (memq kind kinds))
                                   (problem! 'unknown-agent
                                             (string-append "an agent is one of " (names->string kinds))
                                             here)
                                   #f)
                                  ((memq kind (taken))
                                   (problem! 'twice
                                             (string-append "the " (symbol->string kind) " agent has a host already")
                                             here)
                                   #f)
                                  (else (taken kind) kind))))
                        (cdr (section-form agents))
                        (iota (length (cdr (section-form agents))) 1)))
                     '()))))))

;; (taken) answers the kinds that have a host, (taken KIND) adds one.
(define (make-taken)
  (let ((kinds-taken '()))
    (lambda new
      (unless (null? new) (set! kinds-taken (cons (car new) kinds-taken)))
      kinds-taken)))

(define (interpret-hosts form path)
  (let ((hosts (sections form path 'host)))
    (if (null? hosts)
        (list (cons "localhost" kinds))
        (let ((taken (make-taken)))
          (filter-map (lambda (host) (interpret-host host taken)) hosts)))))

(define (interpret-board form path hosts)
  (let ((board (section form path 'board)))
    (if (not board)
        (list (if (null? hosts) "localhost" (car (first hosts))) "")
        (let ((words (cdr (section-form board))))
          (if (and (= (length words) 2) (every string? words))
              words
              (begin
                (problem! 'malformed "a board is (board \"HOST\" \"ADDRESS\")" (section-path board))
                '("localhost" "")))))))

(define (interpret-one form path)
  (check-sections form path 2 '(world arm domain board host))
  (let* ((name (form-name form path))
         (world+path (section form path 'world))
         (world (and world+path (section-form world+path)))
         (world-path (and world+path (section-path world+path)))
         (arm (section form path 'arm))
         (domain (section form path 'domain))
         (hosts (interpret-hosts form path)))
    (when world (check-sections world world-path 1 '(camera cube noise)))
    (let ((cubes (if world
                     (interpret-cubes (map (lambda (cube) (cons (section-form cube) (section-path cube)))
                                           (sections world world-path 'cube)))
                     '())))
      `(cell ,name
             ,(interpret-camera world world-path)
             ,(interpret-noise world world-path)
             ,cubes
             ,(or (and arm (section-choice arm '(crs-f3))) 'crs-f3)
             ,(or (and domain (section-string domain)) "")
             ,@(interpret-board form path hosts)
             ,hosts))))

(define (interpret-cell data)
  (with-problems
   (lambda ()
     (only-form data 'cell interpret-one))))
