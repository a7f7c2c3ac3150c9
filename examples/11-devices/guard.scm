; Stops the arm when something is in the light barrier's beam, and when nobody watches it. Both stops stand until a person
; takes them back, ./pizarra retract '(stop guard ?)': an empty beam does not say that nobody is behind it. They outlive
; this agent, since `stop` is durable in `posts`. While their cause lasts they are told again.
(posts (relation guarded ((barrier symbol)))
       (relation stop ((who symbol) (reason string)) (key who) (durable)))
(reads (relation blocked ((barrier symbol)))
       (relation watching ((barrier symbol))))
(tell (guarded barrier-1))

(rule something-is-there (and (blocked ?b) (not (stop guard ?)))
  (tell (stop guard "something is in the light barrier")))
(rule nobody-watches (and (agent ?arm robot ?) (guarded ?b) (not (watching ?b)) (not (stop guard ?)))
  (tell (stop guard "nobody watches the light barrier")))
