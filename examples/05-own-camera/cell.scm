; The eyes alone, on a camera of your own: print ./pizarra shapes --print shapes.pdf, hold it half a metre before the
; camera, and teach at the prompt. docs/cameras.md shows how, and what else can stand for (device 0).
(cell own-camera
  (camera (single (device 0)) (size 640 480) (learned-at 500))
  (domain "../../domains/blocks.scm")
  (host "localhost" (agents vision)))
