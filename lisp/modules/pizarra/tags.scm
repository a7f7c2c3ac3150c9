;; The tags that a cell's eyes look for without having been shown them: (tags (FAMILY SIDE-MM) ...) in a cell file.
;;
;; (tags-of FOUND), FOUND the sections of a cell, answers ((FAMILY SIDE-MM) ...), or () where it names none. SIDE-MM is
;; that of the dark square, or of the light one of the last three families, within their dark line.

(define-module (pizarra tags)
  #:use-module (srfi srfi-1)
  #:use-module (pizarra forms)
  #:export (tags-of))

;; As the eyes call them.
(define families
  '(apriltag-36h11 apriltag-36h10 apriltag-25h9 apriltag-16h5 aruco-4x4-50 aruco-4x4-1000 aruco-5x5-50 aruco-5x5-1000
    aruco-6x6-50 aruco-6x6-1000 aruco-7x7-50 aruco-7x7-1000 aruco-original
    apriltag-standard41h12 apriltag-circle21h7 apriltag-standard52h13))

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
