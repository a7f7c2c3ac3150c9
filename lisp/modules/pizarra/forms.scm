;; The tools of every interpreter of a person's text.
;;
;; A node is a datum that knows its path (indices from the top of the text) and its context (what it stands in). An
;; interpreter walks nodes, complains about those that are wrong, and goes on, so that one reading reports everything:
;;
;;   (define (interpret data)
;;     (interpreting data
;;       (lambda (file)
;;         (let ((cell (only-form file 'cell)))
;;           (and cell (list 'cell (symbol-at cell 1 "the cell's name")))))))
;;
;;   (interpret '((cell blocks)))  =>  (ok (cell blocks))
;;   (interpret '((cell "b")))     =>  (errors (malformed "the cell's name must be a symbol" (0 1) ()))

(define-module (pizarra forms)
  #:use-module (srfi srfi-1)
  #:use-module (srfi srfi-9)
  #:export (interpreting guessing complain!
            node-datum node-items node-rest node-ref node-head node-within node-form? path-to
            only-form sections section-in sections-in find-section
            symbol-at string-at number-at integer-at symbol-of
            numbers-of numbers-in text-of-section choice-at
            complain-missing! refuse-repeated at-most suggestion nearest-name same-name? find-name object-name?
            plain-name-at))

(define-record-type <node>
  (make-node datum path context)
  node?
  (datum node-datum)
  (path node-path)          ; innermost index first
  (context node-context))   ; innermost first

;; The complaints of the interpretation in hand, newest first, and how many they are.
(define complaints (make-parameter '()))
(define complaint-count (make-parameter 0))

;; Complaints beyond so many are not noted, and nearest names are looked for only at the first: a text may be all wrong.
(define most-complaints 1000)
(define most-suggestions 100)

;; (ok VALUE), VALUE being what (interpreter ROOT) returns, or (errors (SYMBOL SENTENCE PATH CONTEXT) ...) in the
;; order of the text. ROOT's items are the data of the text.
(define (interpreting data interpreter)
  (parameterize ((complaints '()) (complaint-count 0))
    (let* ((value (interpreter (make-node data '() '())))
           (found (reverse (complaints))))
      (if (null? found)
          (list 'ok value)
          (cons 'errors (stable-sort found (lambda (a b) (path<? (third a) (third b)))))))))

;; The result of (interpreter ROOT), whatever it complains about: as much as can be made of a text that is wrong.
(define (guessing data interpreter)
  (parameterize ((complaints '()) (complaint-count 0))
    (interpreter (make-node data '() '()))))

(define (path<? a b)
  (cond ((null? b) #f)
        ((null? a) #t)
        ((= (car a) (car b)) (path<? (cdr a) (cdr b)))
        (else (< (car a) (car b)))))

;; Notes that NODE is wrong; SENTENCE may hold ~a for the values. Always #f, for use as a missing value.
(define (complain! node symbol sentence . values)
  (when (< (complaint-count) most-complaints)
    (complaint-count (+ 1 (complaint-count)))
    (complaints (cons (list symbol
                            (apply simple-format #f sentence values)
                            (path-to node)
                            (reverse (node-context node)))
                      (complaints))))
  #f)

;; Notes where NODE ends, behind whatever else is wrong in it, that it has none of the sections NAMES; unless one is
;; there mistyped, which is complained about as such.
(define (complain-missing! node names sentence . values)
  (let ((items (node-items node)))
    (unless (any (lambda (item) (and (node-head item) (nearest-name (node-head item) names))) items)
      (apply complain! (make-node '() (cons (length items) (node-path node)) (node-context node)) 'malformed sentence
             values))
    #f))

;; The indices from the top of the text to the node.
(define (path-to node)
  (reverse (node-path node)))

;; The same node, its inside standing in one more context: "in operator STACK".
(define (node-within node context)
  (make-node (node-datum node) (node-path node) (cons context (node-context node))))

(define (node-items node)
  (let ((datum (node-datum node)))
    (if (pair? datum)
        (map (lambda (item index)
               (make-node item (cons index (node-path node)) (node-context node)))
             datum
             (iota (length datum)))
        '())))

;; The items after the head.
(define (node-rest node)
  (let ((items (node-items node)))
    (if (null? items) '() (cdr items))))

;; The item at INDEX, or #f.
(define (node-ref node index)
  (let ((datum (node-datum node)))
    (and (list? datum)
         (< index (length datum))
         (make-node (list-ref datum index) (cons index (node-path node)) (node-context node)))))

;; The symbol that a list begins with, or #f.
(define (node-head node)
  (let ((datum (node-datum node)))
    (and (pair? datum) (symbol? (car datum)) (car datum))))

;; Whether NODE is a list that begins with the symbol HEAD; complains where it is not.
(define (node-form? node head)
  (or (eq? (node-head node) head)
      (complain! node 'malformed "this must be a form (~a ...)" head)))

;; The one form that the whole text must be, also where more follows, or #f.
(define (only-form root head)
  (let ((items (node-items root)))
    (cond ((null? items)
           (complain! root 'malformed "nothing is written here: (~a ...) is missing" head))
          ((not (node-form? (car items) head)) #f)
          (else
           (when (pair? (cdr items))
             (complain! (cadr items) 'malformed "only one form (~a ...) may stand here" head))
           (car items)))))

;; Sorts NODES, forms (NAME ...), by name: an association list for section-in and sections-in. Names not ALLOWED and
;; repetitions of those not REPEATABLE are complained about.
(define* (sections nodes allowed #:optional (repeatable '()))
  (let loop ((nodes nodes) (found '()))
    (if (null? nodes)
        (reverse found)
        (let* ((node (car nodes))
               (name (node-head node)))
          (cond ((not name)
                 (complain! node 'malformed "a section (NAME ...) must stand here~a" (suggestion #f allowed))
                 (loop (cdr nodes) found))
                ((not (memq name allowed))
                 (complain! node 'unknown-section "there is no section ~a~a" name (suggestion name allowed))
                 (loop (cdr nodes) found))
                ((and (assq name found) (not (memq name repeatable)))
                 (complain! node 'repeated "there is a section ~a already" name)
                 (loop (cdr nodes) found))
                (else (loop (cdr nodes) (cons (cons name node) found))))))))

;; The first section of that name, or #f.
(define (section-in found name)
  (assq-ref found name))

(define (sections-in found name)
  (filter-map (lambda (entry) (and (eq? (car entry) name) (cdr entry))) found))

;; The first form (NAME ...) inside the text's form (HEAD ...), or #f: for a module that interprets one section of a
;; file whose other sections are another module's.
(define (find-section root head name)
  (any (lambda (form)
         (and (eq? (node-head form) head)
              (find (lambda (item) (eq? (node-head item) name)) (node-rest form))))
       (node-items root)))

(define (item-at node index what kind wanted?)
  (let ((item (node-ref node index)))
    (cond ((not item) (complain! node 'malformed "~a is missing" what))
          ((wanted? (node-datum item)) (node-datum item))
          (else (complain! item 'malformed "~a must be ~a" what kind)))))

(define (symbol-at node index what) (item-at node index what "a symbol" symbol?))
(define (string-at node index what) (item-at node index what "a string" string?))
(define (number-at node index what) (item-at node index what "a number" number?))
(define (integer-at node index what) (item-at node index what "a whole number" exact-integer?))

(define (symbol-of node what)
  (if (symbol? (node-datum node))
      (node-datum node)
      (complain! node 'malformed "~a must be a symbol" what)))

;; ---- the arguments of a section (NAME ARGUMENT ...)

;; As many numbers as RANGES, each a list (LOW HIGH), or #f.
(define (numbers-of node ranges)
  (let ((arguments (node-rest node)))
    (if (not (and (= (length arguments) (length ranges))
                  (every (lambda (argument) (real? (node-datum argument))) arguments)))
        (complain! node 'malformed "(~a ...) takes ~a" (node-datum (node-ref node 0))
                   (if (= (length ranges) 1) "one number" (simple-format #f "~a numbers" (length ranges))))
        (and (every (lambda (argument range)
                      (or (<= (first range) (node-datum argument) (second range))
                          (complain! argument 'out-of-range "this must lie between ~a and ~a"
                                     (first range) (second range))))
                    arguments ranges)
             (map node-datum arguments)))))

;; The numbers of a section that may be missing.
(define (numbers-in found name ranges otherwise)
  (let ((node (section-in found name)))
    (or (and node (numbers-of node ranges)) otherwise)))

(define (text-of-section found name what otherwise)
  (let ((node (section-in found name)))
    (or (and node (string-at node 1 what)) otherwise)))

;; The symbol at INDEX, which must be one of CHOICES.
(define (choice-at node index what choices)
  (let ((choice (symbol-at node index what)))
    (and choice
         (or (find (lambda (known) (eq? known choice)) choices)
             (complain! (node-ref node index) 'unknown-name "~a cannot be ~a~a" what choice
                        (suggestion choice choices))))))

;; ----

;; Complains about every node whose (name-of NODE) an earlier node has; #f is no name.
(define (refuse-repeated nodes name-of what)
  (let ((seen (make-hash-table)))
    (for-each (lambda (node)
                (let ((name (name-of node)))
                  (when (and name (hash-ref seen name))
                    (complain! node 'repeated "there is ~a ~a already" what name))
                  (hash-set! seen name #t)))
              nodes)))

;; The first COUNT of NODES, complaining about the next.
(define (at-most nodes count what)
  (if (<= (length nodes) count)
      nodes
      (begin (complain! (list-ref nodes count) 'too-many "there may be at most ~a ~a" count what)
             (take nodes count))))

;; Whether two names are equal without regard to case.
(define (same-name? a b)
  (string-ci=? (text-of a) (text-of b)))

;; The one of NAMES that NAME is, exactly or else without regard to case; #f where there is none.
(define (find-name name names)
  (or (find (lambda (other) (string=? (text-of name) (text-of other))) names)
      (find (lambda (other) (same-name? name other)) names)))

;; Whether a symbol or string is a name that an object can be learned under: letters, digits and hyphens after a letter.
(define (object-name? name)
  (define (letter? c) (or (char<=? #\a c #\z) (char<=? #\A c #\Z)))
  (let ((text (text-of name)))
    (and (not (string-null? text))
         (letter? (string-ref text 0))
         (string-every (lambda (c) (or (letter? c) (char<=? #\0 c #\9) (char=? c #\-))) text))))

;; Letters, digits and dashes, a letter first: what can name an object, a fact's argument and a file alike.
(define (plain-name? text)
  (and (<= 1 (string-length text) 64)
       (char-set-contains? char-set:letter (string-ref text 0))
       (string-every (char-set-union char-set:letter char-set:digit (char-set #\-)) text)))

(define (plain-name-at node index what)
  (let ((name (symbol-at node index what)))
    (and name
         (or (and (plain-name? (symbol->string name)) name)
             (complain! (node-ref node index) 'malformed "~a has letters, digits and dashes" what)))))

(define (text-of name)
  (if (symbol? name) (symbol->string name) name))

(define most-names-shown 12)
(define longest-name 64)

;; The end of a sentence about an unknown NAME: the nearest of the known NAMES, or else some of them.
(define (suggestion name names)
  (let ((nearest (and name
                      (<= (complaint-count) most-suggestions)
                      (<= (string-length (text-of name)) longest-name)
                      (nearest-name name names))))
    (cond ((> (complaint-count) most-suggestions) "")
          (nearest (simple-format #f "; the nearest is ~a" nearest))
          ((null? names) "; there is none at all")
          (else
           (simple-format #f "; there are ~a~a"
                          (string-join (map text-of (take names (min most-names-shown (length names)))) ", ")
                          (if (> (length names) most-names-shown) ", ..." ""))))))

;; The name at the smallest edit distance, if that is at most a third of the length (one for short names).
(define (nearest-name name names)
  (let* ((text (string-downcase (text-of name)))
         (most (max 1 (quotient (string-length text) 3))))
    (let loop ((names names) (best #f) (best-distance (+ most 1)))
      (if (null? names)
          best
          (let* ((other (string-downcase (text-of (car names))))
                 (distance (if (> (abs (- (string-length other) (string-length text))) most)
                               best-distance
                               (edit-distance text other))))
            (if (< distance best-distance)
                (loop (cdr names) (car names) distance)
                (loop (cdr names) best best-distance)))))))

;; Insertions, deletions, changes and swaps of neighbours (optimal string alignment).
(define (edit-distance a b)
  (let ((columns (+ 1 (string-length b))))
    (let loop ((i 1) (before #f) (above (iota-vector columns)))
      (if (> i (string-length a))
          (vector-ref above (- columns 1))
          (let ((row (make-vector columns i)))
            (do ((j 1 (+ j 1))) ((= j columns))
              (let ((same (char=? (string-ref a (- i 1)) (string-ref b (- j 1)))))
                (vector-set! row j (min (+ 1 (vector-ref above j))
                                        (+ 1 (vector-ref row (- j 1)))
                                        (+ (if same 0 1) (vector-ref above (- j 1)))))
                (when (and before (> j 1)
                           (char=? (string-ref a (- i 1)) (string-ref b (- j 2)))
                           (char=? (string-ref a (- i 2)) (string-ref b (- j 1))))
                  (vector-set! row j (min (vector-ref row j) (+ 1 (vector-ref before (- j 2))))))))
            (loop (+ i 1) above row))))))

(define (iota-vector size)
  (list->vector (iota size)))
