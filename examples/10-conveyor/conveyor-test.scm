; ./pizarra scheme examples/10-conveyor/conveyor.scm --try examples/10-conveyor/conveyor-test.scm
(declare (relation stop ((who symbol) (reason string)) (key who) (durable)))

(tell (barrier exit free))
(expect (belt running))
(absent (passed ?))

(tell (barrier exit blocked))
(expect (belt stopped) (passed 1))
(tell (barrier exit free) (barrier exit blocked))
(expect (passed 2))
(call (reset) ())
(expect (passed 0))

(tell (barrier door blocked))
(expect (stop conveyor "somebody is at the door"))
(tell (barrier door free))
(absent (stop ? ?))
