;; The vision server's replies. The reader yields each comma as a symbol of its own, so that `(112, 87)` and `(112 ,87)`
;; are the same here, and two numbers.
;;
;;   (LEARN "name" OK)                 =>  (learn "name" ok)
;;   (FIND "name" OK (x, y))           =>  (find "name" ok x y)
;;   (TRACK n ("a" OK (x, y, d)) ...)  =>  (track ("a" x y d) ("b" fail) ...)
;;   (GET n ("a", "b", ...))           =>  (get "a" "b" ...)

(define-module (pizarra vision-replies)
  #:use-module (srfi srfi-1)
  #:use-module (pizarra forms)
  #:export (interpret))

(define comma (string->symbol ","))

(define (interpret data)
  (interpreting data
    (lambda (text)
      (let ((items (node-items text)))
        (if (= (length items) 1)
            (read-reply (car items))
            (complain! text 'malformed "a vision reply is one form"))))))

(define (read-reply reply)
  (case (node-head reply)
    ((LEARN) (cons* 'learn (name-at reply 1) (read-verdict reply '())))
    ((FIND) (cons* 'find (name-at reply 1) (read-verdict reply '("x" "y"))))
    ((TRACK) (cons 'track (read-tracked reply)))
    ((GET) (cons 'get (read-names reply)))
    (else (complain! reply 'malformed "a vision reply is a LEARN, FIND, TRACK or GET form"))))

(define (name-at node index)
  (let ((name (string-at node index "an object's name")))
    (when (and name (not (object-name? name)))
      (complain! (node-ref node index) 'malformed "an object's name is letters, digits and hyphens after a letter"))
    name))

;; (HEAD "name" OK NUMBERS) or (HEAD "name" FAIL), NUMBERS being absent where none are WANTED, as (ok number ...) or
;; (fail).
(define (read-verdict reply wanted)
  (let ((verdict (symbol-at reply 2 "the outcome")))
    (case verdict
      ((#f) '())
      ((OK)
       (expect-size reply (if (null? wanted) 3 4))
       (cons 'ok (if (null? wanted) '() (numbers-at reply 3 wanted))))
      ((FAIL)
       (expect-size reply 3)
       '(fail))
      (else
       (complain! (node-ref reply 2) 'malformed "the outcome must be OK or FAIL")
       '()))))

(define (expect-size node size)
  (let ((items (node-items node)))
    (when (> (length items) size)
      (complain! (list-ref items size) 'malformed "nothing may stand here"))))

(define (numbers-at reply index wanted)
  (let ((node (node-ref reply index)))
    (if node
        (let ((items (separated-items node)))
          (cond ((not items) '())
                ((not (and (= (length items) (length wanted))
                           (every number? (map node-datum items))))
                 (complain! node 'malformed "the numbers (~a) must stand here" (string-join wanted ", "))
                 '())
                (else (map node-datum items))))
        (begin (complain! reply 'malformed "the numbers (~a) are missing" (string-join wanted ", "))
               '()))))

;; The items of a list between whose items stands exactly one comma, or #f with a complaint.
(define (separated-items node)
  (define (comma? item) (eq? (node-datum item) comma))
  (cond ((not (list? (node-datum node))) (complain! node 'malformed "a list must stand here"))
        ((null? (node-datum node)) '())
        (else
         (let loop ((items (node-items node)) (found '()))
           (cond ((or (null? items) (comma? (car items)))
                  (complain! (if (null? items) node (car items)) 'malformed "one thing must stand between two commas"))
                 ((null? (cdr items)) (reverse (cons (car items) found)))
                 ((comma? (cadr items)) (loop (cddr items) (cons (car items) found)))
                 (else (complain! (cadr items) 'malformed "a comma is missing before this")))))))

(define (check-count reply count)
  (let ((declared (integer-at reply 1 "the number of objects")))
    (when (and declared (not (= declared count)))
      (complain! (node-ref reply 1) 'wrong-count "~a objects are announced, but ~a follow" declared count))))

(define (read-tracked reply)
  (let ((objects (drop (node-items reply) (min 2 (length (node-items reply))))))
    (check-count reply (length objects))
    (let ((tracked (map read-tracked-object objects)))
      (refuse-repeated objects first-item "the object")
      tracked)))

(define (first-item node)
  (and (node-ref node 0) (node-datum (node-ref node 0))))

(define (read-tracked-object node)
  (if (list? (node-datum node))
      (let ((name (name-at node 0)))
        (case (symbol-at node 1 "the outcome")
          ((OK) (expect-size node 3) (cons name (numbers-at node 2 '("x" "y" "d"))))
          ((FAIL) (expect-size node 2) (list name 'fail))
          ((#f) (list name))
          (else (complain! (node-ref node 1) 'malformed "the outcome must be OK or FAIL") (list name))))
      (begin (complain! node 'malformed "an object (\"name\" OK (x, y, d)) or (\"name\" FAIL) must stand here")
             '())))

(define (read-names reply)
  (expect-size reply 3)
  (let* ((node (node-ref reply 2))
         (items (and node (separated-items node))))
    (unless node (complain! reply 'malformed "the list of names is missing"))
    (when items
      (check-count reply (length items))
      (for-each check-name items)
      (refuse-repeated items node-datum "the object"))
    (map node-datum (or items '()))))

(define (check-name node)
  (unless (and (string? (node-datum node)) (object-name? (node-datum node)))
    (complain! node 'malformed "an object's name must stand here")))
