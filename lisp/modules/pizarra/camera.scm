;; The cameras of a cell that are not simulated: see lisp/forms/camera_setup.hpp for what is said of them.
;;
;; (camera-of-section NODE), NODE the section (camera ARRANGEMENT OPTION ...) of a cell file, answers this form:
;;
;;   (ARRANGEMENT ((KIND WHERE) ...) (WIDTH HEIGHT) RATE EXPOSURE TONES SKEW CALIBRATION FOCAL BASE-LINE LEARNED-AT)
;;
;; ARRANGEMENT is single, side-by-side or pair, or plugin, whose one source is (plugin FILE). KIND is device, video,
;; images, stream or pipeline. TONES is grey or colour. 0 and "" stand for what is left to the device.

(define-module (pizarra camera)
  #:use-module (srfi srfi-1)
  #:use-module (pizarra driver)
  #:use-module (pizarra forms)
  #:export (camera-of-section))

(define arrangements '(single side-by-side pair))
(define kinds '(device video images stream pipeline))
(define options '(size rate exposure tones skew calibration focal base-line learned-at))

;; ---- where images come from

(define (device-at node)
  (let ((number (node-datum (node-ref node 1))))
    (if (and (exact-integer? number) (<= 0 number 63))
        (string-append "/dev/video" (number->string number))
        (string-at node 1 "the device: its number, or its file"))))

;; (KIND WHERE), or #f.
(define (source-of node)
  (let* ((head (node-head node))
         (kind (and (memq head kinds) head))
         (where (and kind (= (length (node-items node)) 2)
                     (if (eq? kind 'device) (device-at node) (string-at node 1 "where the images come from")))))
    (cond ((not kind)
           (complain! node 'unknown-name
                      "images come from (device N), (video FILE), (images FILES), (stream URL) or (pipeline TEXT)~a"
                      (suggestion head kinds)))
          ((not (= (length (node-items node)) 2)) (complain! node 'malformed "(~a ...) takes one place" kind))
          ((not where) #f)
          ((string-null? where) (complain! node 'malformed "(~a ...) names a place" kind))
          (else (list kind where)))))

;; (ARRANGEMENT (SOURCE ...)), or #f.
(define (arrangement-of node)
  (let* ((head (node-head node))
         (arrangement (and (memq head arrangements) head))
         (wanted (if (eq? arrangement 'pair) 2 1))
         (given (node-rest node)))
    (cond ((not arrangement)
           (complain! node 'unknown-name
                      "the cameras are (single SOURCE), (side-by-side SOURCE), (pair LEFT RIGHT) or (plugin FILE)~a"
                      (suggestion head arrangements)))
          ((not (= (length given) wanted))
           (complain! node 'malformed "(~a ...) takes ~a" arrangement
                      (if (= wanted 2) "two sources, the left one first" "one source")))
          (else
           (let ((sources (map source-of given)))
             (cond ((not (every pair? sources)) #f)
                   ((not (= 1 (length (delete-duplicates (map first sources)))))
                    (complain! (second given) 'malformed "both cameras of a pair must be of one kind, here ~a"
                               (first (first sources))))
                   ((not (= wanted (length (delete-duplicates sources))))
                    (complain! (second given) 'repeated "the left camera is this one already"))
                   (else (list arrangement sources))))))))

;; ---- how they are set

(define (one-in found name low high)
  (first (numbers-in found name (list (list low high)) '(0))))

(define (size-of found)
  (let ((size (numbers-in found 'size '((64 8192) (64 8192)) '(0 0))))
    (if (every exact-integer? size)
        size
        (complain! (section-in found 'size) 'malformed "a size is two whole numbers of pixels"))))

(define (tones-of found)
  (let ((node (section-in found 'tones)))
    (or (and node (choice-at node 1 "what is taken" '(colour grey))) 'colour)))

;; An option that has an effect only on some cameras is refused for the others.
(define (check-settings arrangement sources found)
  (let ((exposure (section-in found 'exposure))
        (skew (section-in found 'skew)))
    (when (and exposure (not (eq? (first (first sources)) 'device)))
      (complain! exposure 'malformed "only a (device ...) has (exposure MS)"))
    (when (and skew (not (eq? arrangement 'pair)))
      (complain! skew 'malformed "only a (pair ...) has (skew MS)"))))

;; The size of a pixel in mm must be known, by a calibration or by the numbers of a rectified pair.
(define (check-geometry node arrangement found)
  (let ((calibration (section-in found 'calibration))
        (focal (section-in found 'focal))
        (base-line (section-in found 'base-line))
        (learned-at (section-in found 'learned-at))
        (single (eq? arrangement 'single)))
    (when (and calibration focal)
      (complain! focal 'repeated "the calibration says the focal length already"))
    (when (and calibration base-line)
      (complain! base-line 'repeated "the calibration says the base line already"))
    (when (and base-line single) (complain! base-line 'malformed "one camera alone has no base line"))
    (when (and learned-at (not single)) (complain! learned-at 'malformed "two cameras measure how far objects are"))
    (when (and (not single) (not calibration) (not (and focal base-line)))
      (complain! node 'malformed
                 "two cameras need (calibration FILE), or, already rectified, (focal PX) and (base-line MM)"))))

(define (camera-of-sources node)
  (let* ((arrangement (if (pair? (node-rest node))
                          (arrangement-of (first (node-rest node)))
                          (complain! node 'malformed
                                     "the cameras are (single SOURCE), (side-by-side SOURCE), (pair LEFT RIGHT) or (plugin FILE)")))
         (found (if (pair? (node-rest node)) (sections (cdr (node-rest node)) options) '())))
    (when arrangement
      (check-settings (first arrangement) (second arrangement) found)
      (check-geometry node (first arrangement) found))
    (append (or arrangement '(single ()))
            (list (or (size-of found) '(0 0))
                  (one-in found 'rate 1 240)
                  (one-in found 'exposure 0.01 1000)
                  (tones-of found)
                  (one-in found 'skew 0.1 1000)
                  (text-of-section found 'calibration "the calibration's file" "")
                  (one-in found 'focal 10 100000)
                  (one-in found 'base-line 1 10000)
                  (one-in found 'learned-at 50 100000)))))

;; A plug-in says by itself how large its images are and what their pixels mean.
(define (camera-of-plugin node)
  (let ((file (plugin-at (node-ref node 1))))
    (when (> (length (node-items node)) 2)
      (complain! (node-ref node 2) 'malformed
                 "nothing may follow a camera's plug-in, which tells its size and geometry by itself"))
    (list 'plugin (list (list 'plugin (or file ""))) '(0 0) 0 0 'colour 0 "" 0 0 0)))

(define (camera-of-section section)
  (let* ((node (node-within section "in the camera"))
         (rest (node-rest node)))
    (if (and (pair? rest) (eq? (node-head (first rest)) 'plugin))
        (camera-of-plugin node)
        (camera-of-sources node))))
