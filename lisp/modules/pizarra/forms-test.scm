(use-modules (srfi srfi-1) (pizarra test-checks) (pizarra forms))

(define (read-cell data)
  (interpreting data
    (lambda (file)
      (let ((cell (only-form file 'cell)))
        (and cell (list 'cell (symbol-at cell 1 "the cell's name")))))))

(check "a value is returned" (read-cell '((cell blocks))) '(ok (cell blocks)))
(check "the path leads to the wrong element" (read-cell '((cell "b")))
       '(errors (malformed "the cell's name must be a symbol" (0 1) ())))
(check "a missing element is its list's fault" (read-cell '((cell)))
       '(errors (malformed "the cell's name is missing" (0) ())))
(check "another form is refused" (read-cell '((sell blocks)))
       '(errors (malformed "this must be a form (cell ...)" (0) ())))
(check "a second form is refused" (read-cell '((cell blocks) (cell blocks)))
       '(errors (malformed "only one form (cell ...) may stand here" (1) ())))
(check "what is wrong in the first is told beside the second" (read-cell '((cell "b") (cell blocks)))
       '(errors (malformed "the cell's name must be a symbol" (0 1) ())
                (malformed "only one form (cell ...) may stand here" (1) ())))
(check "an empty text is refused" (car (read-cell '())) 'errors)

(define (read-sections data)
  (interpreting data
    (lambda (file)
      (let ((found (sections (node-items (node-within file "in a file")) '(arm camera) '(camera))))
        (list (and (section-in found 'arm) (node-datum (section-in found 'arm)))
              (map node-datum (sections-in found 'camera)))))))

(check "sections are sorted" (read-sections '((camera 1) (arm 2) (camera 3))) '(ok ((arm 2) ((camera 1) (camera 3)))))
(check "all complaints come in the text's order" (read-sections '((arm 1) (camra 2) (arm 3) 4))
       '(errors (unknown-section "there is no section camra; the nearest is camera" (1) ("in a file"))
                (repeated "there is a section arm already" (2) ("in a file"))
                (malformed "a section (NAME ...) must stand here; there are arm, camera" (3) ("in a file"))))

(check "a section is found inside its form"
       (interpreting '((domain d (perception (rule 1))))
         (lambda (file)
           (complain! (node-ref (find-section file 'domain 'perception) 1) 'odd "odd")))
       '(errors (odd "odd" (0 2 1) ())))

(check "swapped letters are near" (suggestion 'traingle '(circle triangle)) "; the nearest is triangle")
(check "case does not count" (suggestion 'CIRCEL '(circle triangle)) "; the nearest is circle")
(check "nothing near lists what there is" (suggestion 'star '(circle cross)) "; there are circle, cross")
(check "nothing to list" (suggestion 'star '()) "; there is none at all")
(check "an exact name wins over another case" (find-name 'A '(a A)) 'A)
(check "a name of another case is found" (find-name "Circle" '(circle)) 'circle)

(check "the first too many is complained about"
       (interpreting '(a b c)
         (lambda (file) (map node-datum (at-most (node-items file) 2 "letters"))))
       '(errors (too-many "there may be at most 2 letters" (2) ())))
(check "complaints have a bound"
       (length (interpreting (iota 5000)
                 (lambda (file) (for-each (lambda (node) (complain! node 'odd "odd")) (node-items file)))))
       1001)

;; That a section is missing, after everything else.
(define (read-goal . items)
  (interpreting (list items)
    (lambda (file)
      (let ((node (node-ref file 0)))
        (complain-missing! node '(goal) "(goal) is missing")
        (for-each (lambda (item) (symbol-of item "an item")) (node-items node))))))
(check "what is missing is complained about last, where the list ends" (map third (cdr (read-goal 'a 3)))
       '((0 1) (0 2)))
(check "what is mistyped is not missing" (map third (cdr (read-goal 'a '(gaol)))) '((0 1)))
(check "a text that is wrong can be understood in part"
       (guessing '(a 3) (lambda (file) (filter-map (lambda (node) (symbol-of node "an item")) (node-items file))))
       '(a))

(finish-checks)
