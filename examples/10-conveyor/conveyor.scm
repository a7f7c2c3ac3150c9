; A conveyor beside the cell, as rules: while the barrier at its exit is blocked the belt stands, and while somebody is
; at the door the arm stands. Save this file while the cell runs, and the new rules count at once.
(posts (relation belt ((state symbol)) (key))
       (relation passed ((count integer)) (key) (durable)))
(reads (relation barrier ((name symbol) (state symbol)) (key name)))

(define count 0)

(rule piece-arrives (barrier exit blocked)
  (set! count (+ count 1))
  (tell (belt stopped) (passed ,count)))
(rule piece-taken (barrier exit free)
  (tell (belt running)))
(conclude arm-stands (barrier door blocked)
  (stop conveyor "somebody is at the door"))
(operation (reset)
  (set! count 0)
  (tell (passed 0)))
