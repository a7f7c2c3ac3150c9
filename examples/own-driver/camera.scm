; A cell whose eyes look through a plug-in: PIZARRA_PLUGINS=examples/own-driver/build ./pizarra up
; examples/own-driver/camera.scm, once libmycamera.so was built there.
(cell own-camera
  (camera (plugin "libmycamera.so"))
  (host "localhost" (agents vision)))
