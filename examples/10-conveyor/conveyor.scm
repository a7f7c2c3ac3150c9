; A conveyor beside the cell, as rules: while the barrier at its exit is blocked the belt stands, and the arm is stopped
; when the barrier at the door is blocked, until a person takes the stop back. That is no safety function. Save this file
; while the cell runs, and the new rules count at once.
(posts (relation belt ((state symbol)) (key))
       (relation passed ((count integer)) (key) (durable))
       (relation stop ((who symbol) (reason string)) (key who) (durable)))
(reads (relation barrier ((name symbol) (state symbol)) (key name)))

(define count 0)

(rule piece-arrives (barrier exit blocked)
  (set! count (+ count 1))
  (tell (belt stopped) (passed ,count)))
(rule piece-taken (barrier exit free)
  (tell (belt running)))
(rule arm-stands (and (barrier door blocked) (not (stop conveyor ?)))
  (tell (stop conveyor "the barrier at the door is blocked")))
(operation (reset)
  (set! count 0)
  (tell (passed 0)))
