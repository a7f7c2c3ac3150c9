; Keeps the arm from the light barrier: it stands while something is in the beam, and while nobody watches that.
(posts (relation guarded ((barrier symbol))))
(reads (relation blocked ((barrier symbol)))
       (relation watching ((barrier symbol))))
(tell (guarded barrier-1))

(conclude something-is-there (blocked barrier-1)
  (stop barrier-1 "something is in the light barrier"))
(conclude nobody-watches (and (agent ?arm robot ?) (guarded ?b) (not (watching ?b)))
  (stop guard "nobody watches the light barrier"))
