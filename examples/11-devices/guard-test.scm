; ./pizarra scheme examples/11-devices/guard.scm --try examples/11-devices/guard-test.scm
(declare (relation stop ((who symbol) (reason string)) (key who) (durable)))
(tell (agent robot robot "here"))

(expect (stop guard "nobody watches the light barrier"))
(tell (watching barrier-1))
(absent (stop ? ?))
(tell (blocked barrier-1))
(expect (stop barrier-1 "something is in the light barrier"))
(retract (blocked barrier-1))
(absent (stop ? ?))
(retract (watching barrier-1))
(expect (stop guard "nobody watches the light barrier"))
