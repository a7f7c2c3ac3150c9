;; The text door of a cell: see lisp/forms/cell_file.hpp.
;;
;; (door-of FOUND BOARD-KEYS), FOUND the sections of a cell, answers (PORT ((FILE BAUD) ...) KEYS).
;; PORT is -1 if the door is not reached over TCP. A cell without a (door ...) gives ().
;; BOARD-KEYS is the folder of keys that is taken where the door names none.

(define-module (pizarra door)
  #:use-module (srfi srfi-1)
  #:use-module (pizarra forms)
  #:use-module (pizarra lines)
  #:export (door-of))

(define default-baud 115200)

(define (door-port-of found)
  (let* ((tcp (section-in found 'tcp)) (port (and tcp (port-at tcp 1 0))))
    (cond ((not port) -1)
          ((> (length (node-items tcp)) 2) (complain! (node-ref tcp 2) 'malformed "(tcp PORT) takes one port") -1)
          (else port))))

(define (door-line-of node)
  (let* ((file (string-at node 1 "the line's file")) (baud (baud-at node 2 default-baud)))
    (cond ((not (and file baud)) #f)
          ((not (string-prefix? "/dev/" file))
           (complain! (node-ref node 1) 'malformed "a serial line is a file of /dev/"))
          ((> (length (node-items node)) 3)
           (complain! (node-ref node 3) 'malformed "(serial FILE BAUD) takes no more"))
          (else (list file baud)))))

(define (door-of found board-keys)
  (let ((door (section-in found 'door)))
    (if (not door)
        '()
        (let* ((parts (sections (node-rest (node-within door "in the door")) '(tcp serial keys) '(serial)))
               (port (door-port-of parts))
               (lines (filter-map door-line-of (at-most (sections-in parts 'serial) 16 "serial lines")))
               (keys (text-of-section parts 'keys "the folder of the devices' keys" board-keys)))
          (unless (or (section-in parts 'tcp) (pair? (sections-in parts 'serial)))
            (complain! door 'malformed "the door needs (tcp PORT) or (serial \"FILE\" BAUD), or both"))
          (when (string-null? keys)
            (complain! door 'malformed "the door needs the folder of its devices' keys: (keys \"DIR\")"))
          (list port lines keys)))))
