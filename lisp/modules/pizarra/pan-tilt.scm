;; The pan-tilt unit that a cell's agent turns, where it is not the simulated one: see lisp/forms/cell_file.hpp.
;;
;; (pan-tilt-of FOUND), FOUND the sections of a cell, answers (LINE WHERE NUMBER (AXIS ...)).
;; LINE is serial, tcp, or the empty string where there is no such unit. NUMBER is a baud rate or a port.
;; The axes are those that the unit counts the other way round.

(define-module (pizarra pan-tilt)
  #:use-module (srfi srfi-1)
  #:use-module (pizarra forms)
  #:use-module (pizarra lines)
  #:export (pan-tilt-of))

(define at-a-line "the pan-tilt unit is at (serial FILE BAUD) or (tcp HOST PORT)")

;; (serial PATH [BAUD]) or (tcp HOST PORT), as (LINE WHERE NUMBER).
(define (line-of node)
  (let ((line (node-head node)))
    (case line
      ((serial) (reached line (string-at node 1 "the line's file") (baud-at node 2 9600)))
      ((tcp) (reached line (string-at node 1 "the unit's address") (port-at node 2 1)))
      (else (complain! node 'malformed at-a-line)))))

(define (reached line where number)
  (and where number (list line where number)))

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
                           (complain! inside 'malformed at-a-line)))
               (reversed (and others (section-in others 'reversed))))
          (append (or line (list "" "" 0))
                  (list (if reversed (filter-map axis-of (node-rest reversed)) '())))))))
