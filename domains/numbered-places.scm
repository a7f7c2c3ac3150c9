; Cubes on a table that has only numbered places: a cube may be put down where a place is free, and nowhere else. To
; swap two cubes, a free place or the top of a third cube is needed. Nothing here needs other C++ than blocks.scm does.
(domain numbered-places
  (types OBJECT PLACE)
  (objects (place-1 PLACE) (place-2 PLACE) (place-3 PLACE) (place-4 PLACE))
  (predicates
    (on (upper OBJECT) (lower OBJECT))
    (at (ob OBJECT) (where PLACE))
    (free (where PLACE))
    (clear (ob OBJECT))
    (holding (ob OBJECT))
    (arm-empty))

  (operator TAKE
    (params (<ob> OBJECT) (<from> PLACE))
    (preconds (at <ob> <from>) (clear <ob>) (arm-empty))
    (effects (holding <ob>) (free <from>) (del (at <ob> <from>)) (del (clear <ob>)) (del (arm-empty))))
  (operator PUT
    (params (<ob> OBJECT) (<to> PLACE))
    (preconds (holding <ob>) (free <to>))
    (effects (at <ob> <to>) (clear <ob>) (arm-empty) (del (holding <ob>)) (del (free <to>))))
  (operator STACK
    (params (<ob> OBJECT) (<lower> OBJECT))
    (preconds (holding <ob>) (clear <lower>))
    (effects (on <ob> <lower>) (clear <ob>) (arm-empty) (del (clear <lower>)) (del (holding <ob>))))
  (operator UNSTACK
    (params (<ob> OBJECT) (<lower> OBJECT))
    (preconds (on <ob> <lower>) (clear <ob>) (arm-empty))
    (effects (holding <ob>) (clear <lower>) (del (on <ob> <lower>)) (del (clear <ob>)) (del (arm-empty))))

  (perception
    (sees OBJECT)
    (constant cube 60)
    (constant resting 0.8)
    (constant half-pitch 50)            ; a cube lies at the place whose middle is less far away than this

    ; (spot PLACE X Y): where the middle of a cube at this place stands on the table.
    (fact (spot place-1 450 -200))
    (fact (spot place-2 450 -100))
    (fact (spot place-3 450 0))
    (fact (spot place-4 450 100))

    (rule (holding ?o)
      (gripper ?opening)
      (< (abs (- ?opening cube)) (if (was (holding ?)) 9 7))
      (grip ?gx ?gy ?gz)
      (seen ?o ?x ?y ?z)
      ; It may have slipped as far as the fingers reach, and still be held.
      (< (abs (- ?x ?gx)) (if (was (holding ?o)) 36 32))
      (< (abs (- ?y ?gy)) (if (was (holding ?o)) 22 18))
      (< (abs (- ?z ?gz)) (if (was (holding ?o)) 48 44)))

    (rule (holding ?o)                  ; lost from sight for a moment, but still something is between the fingers
      (was (holding ?o))
      (unseen ?o)
      (gripper ?opening)
      (< (abs (- ?opening cube)) 9))

    (rule (on ?a ?b)
      (seen ?a ?ax ?ay ?az)
      (not (holding ?a))
      (seen ?b ?bx ?by ?bz)
      (/= ?a ?b)
      (not (holding ?b))
      (< (abs (- (- ?az ?bz) cube)) (if (was (on ?a ?b)) 16 12))
      (< (abs (- ?ay ?by)) (+ (* 0.5 cube) (if (was (on ?a ?b)) 4 1)))
      (< (abs (- ?ax ?bx)) (+ (* 0.5 cube) (if (was (on ?a ?b)) 10 6))))

    (rule (at ?a ?place)
      (seen ?a ? ?y ?z)
      (< ?z (* resting cube))
      (not (holding ?a))
      (not (on ?a ?))
      (spot ?place ? ?py)
      (< (abs (- ?y ?py)) half-pitch))

    (rule (free ?place)
      (spot ?place ? ?)
      (not (at ? ?place)))

    (rule (askew ?a)                    ; neither flat on the table nor on a cube: not to be built on
      (seen ?a ? ? ?z)
      (<= (* resting cube) ?z)
      (not (holding ?a))
      (not (on ?a ?)))

    (rule (clear ?a)
      (seen ?a ? ? ?)
      (not (holding ?a))
      (not (askew ?a))
      (not (on ? ?a)))

    (rule (arm-empty)
      (not (holding ?))))

  (micro-tasks
    (GRASP (<ob>)
      (open <ob>) (raise) (make-room <ob>) (open <ob>)
      (turn-fingers <ob>) (align <ob>) (lower <ob>) (close) (raise) (square-up) (check-held <ob>))
    (RELEASE-AT (<target>)
      (raise) (square-up) (align <target>) (lower <target>) (release) (raise))

    (TAKE (<ob> <from>) (GRASP <ob>))
    (UNSTACK (<ob> <lower>) (GRASP <ob>))
    (STACK (<ob> <lower>) (RELEASE-AT (on-top <ob> <lower>)))
    (PUT (<ob> <to>) (RELEASE-AT (at-place <ob> <to>)))))
