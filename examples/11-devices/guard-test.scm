; ./pizarra scheme examples/11-devices/guard.scm --try examples/11-devices/guard-test.scm
(tell (agent robot robot "here"))

; A stop stands when its cause has gone, until a person takes it back.
(expect (stop guard "nobody watches the light barrier"))
(tell (watching barrier-1))
(wait 1000)
(expect (stop guard ?))
(retract (stop guard ?))
(wait 1000)
(absent (stop ? ?))

(tell (blocked barrier-1))
(expect (stop guard "something is in the light barrier"))
(retract (stop guard ?))
(expect (stop guard "something is in the light barrier"))
(retract (blocked barrier-1))
(wait 1000)
(expect (stop guard "something is in the light barrier"))
(retract (stop guard ?))
(wait 1000)
(absent (stop ? ?))

(retract (watching barrier-1))
(expect (stop guard "nobody watches the light barrier"))
