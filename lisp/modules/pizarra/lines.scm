;; The lines by which devices are reached.
;;
;; (baud-at NODE INDEX OTHERWISE) answers the baud rate that stands there, OTHERWISE where nothing does, or #f.
;; (port-at NODE INDEX LOWEST) answers the port that stands there, or #f; LOWEST is 0 where any free one may be meant.

(define-module (pizarra lines)
  #:use-module (pizarra forms)
  #:export (baud-at port-at))

(define baud-rates '(9600 19200 38400 57600 115200))
(define highest-port 65535)

(define (baud-at node index otherwise)
  (let ((baud (if (= (length (node-items node)) index) otherwise (integer-at node index "the baud rate"))))
    (cond ((not baud) #f)
          ((memv baud baud-rates) baud)
          (else (complain! (node-ref node index) 'out-of-range
                           "serial lines run at 9600, 19200, 38400, 57600 or 115200 baud")))))

(define (port-at node index lowest)
  (let ((port (integer-at node index "the port")))
    (cond ((not port) #f)
          ((<= lowest port highest-port) port)
          (else (complain! (node-ref node index) 'out-of-range "a port is a number from ~a to ~a" lowest
                           highest-port)))))
