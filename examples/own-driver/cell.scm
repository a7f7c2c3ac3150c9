; A cell whose arm is driven by a plug-in: PIZARRA_PLUGINS=examples/own-driver/build ./pizarra up
; examples/own-driver/cell.scm, once libmyarm.so was built there.
(cell own-driver
  (arm "my-arm.scm" (plugin "libmyarm.so"))
  (host "localhost" (agents robot)))
