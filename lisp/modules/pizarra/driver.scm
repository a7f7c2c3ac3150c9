;; How a cell reaches the controller of a device of its own.
;;
;; (driver-of-section NODE PROTOCOLS), NODE the section (driver PROTOCOL PLACE ... PORT ...), answers
;;   (PROTOCOL (PLACE ...) (PORT ...)), or ()
;; PROTOCOLS being ((PROTOCOL (WHAT-PLACE-IS ...) (PORT-OTHERWISE ...)) ...).
;; (plugin-at NODE), NODE the section (plugin "FILE"), answers the file of a plug-in, or #f. It has no folder: those that
;; plug-ins may lie in are the machine's.

(define-module (pizarra driver)
  #:use-module (srfi srfi-1)
  #:use-module (pizarra forms)
  #:export (driver-of-section plugin-at))

(define (driver-of-section node protocols)
  (let* ((name (choice-at node 1 "the protocol" (map first protocols)))
         (protocol (and name (assq name protocols))))
    (if (not protocol)
        '()
        (let* ((place-at (lambda (index what) (string-at node (+ index 2) what)))
               (places (map place-at (iota (length (second protocol))) (second protocol)))
               (given (drop (node-items node) (min (length (node-items node)) (+ 2 (length places)))))
               (ports (third protocol)))
          (for-each (lambda (port)
                      (unless (and (exact-integer? (node-datum port)) (<= 1 (node-datum port) 65535))
                        (complain! port 'out-of-range "a port is a number from 1 to 65535")))
                    given)
          (when (> (length given) (length ports))
            (complain! (list-ref given (length ports)) 'malformed "~a takes ~a ports at most" name (length ports)))
          (if (every identity places)
              (list name places
                    (append (map node-datum given) (list-tail ports (min (length ports) (length given)))))
              '())))))

(define (plugin-at node)
  (let ((file (string-at node 1 "the plug-in's file")))
    (cond ((not file) #f)
          ((string-index file #\/)
           (complain! (node-ref node 1) 'malformed "a plug-in is named by its file's name alone, such as libmyarm.so"))
          ((> (length (node-items node)) 2)
           (complain! (node-ref node 2) 'malformed "a plug-in is one file"))
          (else file))))
