;; Tags in cell files: those that a cell's eyes look for without having been shown them, (tags (FAMILY SIDE-MM) ...);
;; objects that they know by their tags, (tagged (NAME FAMILY NUMBER SIDE-MM) ...); and the tag that a cube of the world
;; wears, (mark FAMILY NUMBER).
;;
;; (tags-of FOUND), FOUND the sections of a cell, answers ((FAMILY SIDE-MM) ...), or () where it names none. SIDE-MM is
;; that of the dark square, or of the light one of the last three families, within their dark line.
;; (tagged-of FOUND) answers ((NAME FAMILY NUMBER SIDE-MM) ...), or ().
;; (refuse-more NODE COUNT FORM) complains where NODE has more than COUNT items, the form being written so.
;; (tag-at NODE), of a list that ends with a family and a number, answers the tag's name, as apriltag-36h11-17, or #f.

(define-module (pizarra tags)
  #:use-module (srfi srfi-1)
  #:use-module (pizarra forms)
  #:export (dark-families tags-of tagged-of tag-at refuse-more))

;; As the eyes call them.
(define families
  '(apriltag-36h11 apriltag-36h10 apriltag-25h9 apriltag-16h5 aruco-4x4-50 aruco-4x4-1000 aruco-5x5-50 aruco-5x5-1000
    aruco-6x6-50 aruco-6x6-1000 aruco-7x7-50 aruco-7x7-1000 aruco-original
    apriltag-standard41h12 apriltag-circle21h7 apriltag-standard52h13))

;; Those whose square is dark, with how many tags each has.
(define sizes
  '((apriltag-36h11 . 587) (apriltag-36h10 . 2320) (apriltag-25h9 . 35) (apriltag-16h5 . 30)
    (aruco-4x4-50 . 50) (aruco-4x4-1000 . 1000) (aruco-5x5-50 . 50) (aruco-5x5-1000 . 1000)
    (aruco-6x6-50 . 50) (aruco-6x6-1000 . 1000) (aruco-7x7-50 . 50) (aruco-7x7-1000 . 1000) (aruco-original . 1024)))

(define dark-families (map car sizes))

;; Each family costs as much as all of a look at the image without it.
(define most-families 4)

(define side-mm '(5 2000))

(define (tags-of found)
  (let* ((node (section-in found 'tags))
         (given (if node (node-rest (node-within node "in the tags")) '()))
         (parts (sections (at-most given most-families "families of tags") families)))
    (when (and node (null? given))
      (complain! node 'malformed "tags are (tags (FAMILY SIDE) ...), the side of the square in mm"))
    (filter-map (lambda (family)
                  (let* ((part (section-in parts family))
                         (side (and part (numbers-of part (list side-mm)))))
                    (and side (cons family side))))
                families)))

;; (FAMILY NUMBER) at these places of NODE, or #f.
(define (family-and-number node index)
  (let* ((family (choice-at node index "the family of the tag" dark-families))
         (number (and family (integer-at node (+ index 1) "the tag's number")))
         (last (and number (- (assq-ref sizes family) 1))))
    (cond ((not number) #f)
          ((<= 0 number last) (list family number))
          (else (complain! (node-ref node (+ index 1)) 'out-of-range "~a has the tags 0 to ~a" family last)))))

(define (refuse-more node count form)
  (let ((more (node-ref node count)))
    (when more (complain! more 'malformed "nothing more may stand in ~a" form))))

(define (tag-at node)
  (let ((tag (family-and-number node 1)))
    (refuse-more node 3 "(mark FAMILY NUMBER)")
    (and tag
         (symbol-append (first tag) '- (string->symbol (number->string (second tag)))))))

;; The eyes know 32 objects, the gripper's mark among them.
(define most-tagged 31)

(define (tagged-object node)
  (let* ((name (plain-name-at node 0 "the object's name"))
         (tag (and name (family-and-number node 1)))
         (side (and tag (number-at node 3 "the side of the tag's dark square"))))
    (refuse-more node 4 "(NAME FAMILY NUMBER SIDE)")
    (cond ((not side) #f)
          ((<= (first side-mm) side (second side-mm)) `(,name ,@tag ,side))
          (else (complain! (node-ref node 3) 'out-of-range "this must lie between ~a and ~a" (first side-mm)
                           (second side-mm))))))

(define (tagged-of found)
  (let* ((node (section-in found 'tagged))
         (given (if node (node-rest (node-within node "in the tagged objects")) '())))
    (when (and node (null? given))
      (complain! node 'malformed "tagged objects are (tagged (NAME FAMILY NUMBER SIDE) ...)"))
    (refuse-repeated given (lambda (one) (and=> (node-head one) (lambda (name) (string-downcase (symbol->string name)))))
                     "an object")
    (refuse-repeated given (lambda (one) (and (pair? (node-datum one)) (list? (node-datum one))
                                              (>= (length (node-datum one)) 3)
                                              (list (second (node-datum one)) (third (node-datum one)))))
                     "an object with the tag")
    (filter-map tagged-object (at-most given most-tagged "objects with tags"))))
