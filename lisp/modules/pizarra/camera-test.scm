(use-modules (pizarra cell-test-checks) (pizarra test-checks))

;; The value of a cell file with these words in its (camera ...), or how many complaints it has and the first one.
(define (camera . words)
  (cell-part 'eyes `(camera ,@words)))

(check "a cell without words about cameras has the simulated ones"
       (cell-part 'eyes) '())
(check "one camera leaves the rest to its device" (camera '(single (device 0)))
       '(single ((device "/dev/video0")) (0 0) 0 0 colour 0 "" 0 0 0))
(check "all can be said"
       (camera '(pair (device "/dev/left") (device "/dev/right")) '(size 1280 960) '(rate 120) '(exposure 2.5)
               '(tones grey) '(skew 4) '(calibration "pair.calibration"))
       '(pair ((device "/dev/left") (device "/dev/right")) (1280 960) 120 2.5 grey 4 "pair.calibration" 0 0 0))
(check "a rectified pair needs no calibration"
       (camera '(side-by-side (video "film.avi")) '(focal 500) '(base-line 60))
       '(side-by-side ((video "film.avi")) (0 0) 0 0 colour 0 "" 500 60 0))
(check "one camera says where objects are when they are learned"
       (list-ref (camera '(single (images "shots")) '(learned-at 600)) 10) 600)
(check "the cell's own cameras have no simulated person before them"
       (cell-part 'hosts '(camera (single (device 0))))
       '(("localhost" "" robot vision planner coordinator)))
(check "a person asked for beside them is refused"
       (complaint '(camera (single (device 0))) '(host "a" (agents vision person))) '(1 unknown-agent (0 3 2 2)))
(check "a plug-in says all of itself" (camera '(plugin "libmycamera.so"))
       '(plugin ((plugin "libmycamera.so")) (0 0) 0 0 colour 0 "" 0 0 0))
(check "a plug-in has no folder" (camera '(plugin "/tmp/libmycamera.so")) '(1 malformed (0 2 1 1)))
(check "a plug-in has a file" (camera '(plugin)) '(1 malformed (0 2 1)))
(check "a plug-in is one file" (camera '(plugin "a.so" "b.so")) '(1 malformed (0 2 1 2)))
(check "a plug-in takes no option" (camera '(plugin "libmycamera.so") '(rate 10)) '(1 malformed (0 2 2)))
(check "a cell that looks through a plug-in has no simulated person"
       (cell-part 'hosts '(camera (plugin "libmycamera.so")))
       '(("localhost" "" robot vision planner coordinator)))
(check "something must give images" (camera) '(1 malformed (0 2)))
(check "an arrangement that is not known is refused" (camera '(twin (device 0))) '(1 unknown-name (0 2 1)))
(check "a source that is not known is refused" (camera '(single (usb 0))) '(1 unknown-name (0 2 1 1)))
(check "a source has a place" (camera '(single (video))) '(1 malformed (0 2 1 1)))
(check "a device is a number or a file" (camera '(single (device front))) '(1 malformed (0 2 1 1 1)))
(check "a pair has two" (camera '(pair (device 0))) '(1 malformed (0 2 1)))
(check "a pair has two of a kind" (camera '(pair (device 0) (video "a.avi")) '(focal 500) '(base-line 60))
       '(1 malformed (0 2 1 2)))
(check "a pair has two cameras" (camera '(pair (device 1) (device 1)) '(focal 500) '(base-line 60))
       '(1 repeated (0 2 1 2)))
(check "two cameras that nothing is known of are refused" (camera '(pair (device 0) (device 1))) '(1 malformed (0 2)))
(check "one camera alone is calibrated too" (list-ref (camera '(single (device 0)) '(calibration "c")) 7) "c")
(check "a calibration says the focal length" (camera '(single (device 0)) '(calibration "c") '(focal 500))
       '(1 repeated (0 2 3)))
(check "what is too large is refused" (camera '(single (device 0)) '(size 9000 100) '(rate 500))
       '(2 out-of-range (0 2 2 1)))
(check "only a device takes an exposure" (camera '(single (images "shots")) '(exposure 8)) '(1 malformed (0 2 2)))
(check "only a pair has a skew" (camera '(single (device 0)) '(skew 10)) '(1 malformed (0 2 2)))
(check "a word that is not known is refused" (camera '(single (device 0)) '(exposur 3)) '(1 unknown-section (0 2 2)))

(finish-checks)
