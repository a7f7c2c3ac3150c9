; The thesis' task: marked cubes on a table, stacked by an arm with one gripper.
;
; Operators are the four of its Table 6.5, with their deletes stated, and two for what people and accidents leave: LIFT
; takes a cube off something that is not seen, FREE pushes one over that lies askew. A cube that bears nothing is named
; apart (bare) for FREE: a cube that leans is not to be built on, but may be pushed over.
; Lengths are mm.
(domain blocks
  (types OBJECT)
  (predicates
    (on (upper OBJECT) (lower OBJECT))
    (on-table (ob OBJECT))
    (clear (ob OBJECT))                 ; it can be gripped or built on: it bears nothing, lies flat and is not held
    (bare (ob OBJECT))                  ; nothing stands or leans on it, however it lies
    (holding (ob OBJECT))
    (arm-empty)
    (leans (ob OBJECT) (support OBJECT))    ; it fell and lies askew: neither flat on the table nor squarely on a cube
    (raised (ob OBJECT)))               ; it rests on something that is not seen

  (operator PICK-UP
    (params (<ob1> OBJECT))
    (preconds (clear <ob1>) (on-table <ob1>) (arm-empty))
    (effects (holding <ob1>) (del (clear <ob1>)) (del (on-table <ob1>)) (del (arm-empty))))
  (operator PUT-DOWN
    (params (<ob1> OBJECT))
    (preconds (holding <ob1>))
    (effects (clear <ob1>) (arm-empty) (on-table <ob1>) (del (holding <ob1>))))
  (operator STACK
    (params (<ob1> OBJECT) (<ob2> OBJECT))
    (preconds (clear <ob2>) (holding <ob1>))
    (effects (arm-empty) (clear <ob1>) (on <ob1> <ob2>)
             (del (clear <ob2>)) (del (bare <ob2>)) (del (holding <ob1>))))
  (operator UNSTACK
    (params (<ob1> OBJECT) (<ob2> OBJECT))
    (preconds (on <ob1> <ob2>) (clear <ob1>) (arm-empty))
    (effects (holding <ob1>) (clear <ob2>) (bare <ob2>)
             (del (on <ob1> <ob2>)) (del (clear <ob1>)) (del (arm-empty))))

  (operator LIFT
    (params (<ob1> OBJECT))
    (preconds (clear <ob1>) (raised <ob1>) (arm-empty))
    (effects (holding <ob1>) (del (clear <ob1>)) (del (raised <ob1>)) (del (arm-empty))))
  (operator FREE
    (params (<ob1> OBJECT) (<ob2> OBJECT))
    (preconds (leans <ob1> <ob2>) (bare <ob1>) (arm-empty))
    (effects (on-table <ob1>) (clear <ob1>) (clear <ob2>) (bare <ob2>) (del (leans <ob1> <ob2>))))

  ; The measurements of a look: (seen NAME X Y Z) is where a mark stands, (grip X Y Z) where the mark of a held object
  ; would stand; (gripper OPENING) is measured between the fingers; (unseen NAME) is of a mark seen a moment ago.
  ; Beliefs have wider bounds than new sightings, so that noise at a bound does not make them flicker.
  (perception
    (sees OBJECT)
    (constant cube 60)                  ; a cell says otherwise with (cube-size MM)
    (constant resting 0.8)              ; cubes: a mark lower than this belongs to one that lies on the table

    (rule (holding ?o)
      (gripper ?opening)
      (< (abs (- ?opening cube)) (if (was (holding ?)) 9 7))
      (grip ?gx ?gy ?gz)
      (seen ?o ?x ?y ?z)
      ; It may have slipped as far as the fingers reach, and still be held.
      (< (abs (- ?x ?gx)) (if (was (holding ?o)) 36 32))
      (< (abs (- ?y ?gy)) (if (was (holding ?o)) 22 18))
      ; What stands below what is held is a whole cube away.
      (< (abs (- ?z ?gz)) (* (if (was (holding ?o)) 0.8 0.73) cube)))

    (rule (holding ?o)                  ; lost from sight for a moment, but still something is between the fingers
      (unseen ?o)
      (was (holding ?o))
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

    (rule (leans ?a ?b)
      (seen ?a ?ax ?ay ?az)
      (< (+ (* resting cube) (if (was (on-table ?a)) 4 0)) ?az)
      (not (holding ?a))
      (not (on ?a ?))
      (seen ?b ?bx ?by ?bz)
      (/= ?a ?b)
      (not (holding ?b))
      (< 12 (- ?az ?bz))
      (< (- ?az ?bz) (* (if (was (leans ?a ?b)) 1.7 1.6) cube))   ; what is higher up is not held by this one
      (< (abs (- ?ay ?by)) (+ cube 6))
      (< (abs (- ?ax ?bx)) (+ cube 6)))

    (rule (on-table ?a)
      (seen ?a ? ? ?z)
      (< ?z (+ (* resting cube) (if (was (on-table ?a)) 4 0)))
      (not (holding ?a))
      (not (on ?a ?))
      (not (leans ?a ?)))

    (rule (raised ?a)
      (seen ?a ? ? ?z)
      (<= (* resting cube) ?z)
      (< ?z (+ cube (* resting cube)))
      (not (holding ?a))
      (not (on ?a ?))
      (not (leans ?a ?))
      (not (on-table ?a)))

    (rule (bare ?a)
      (seen ?a ? ? ?)
      (not (on ? ?a))
      (not (leans ? ?a)))

    (rule (clear ?a)
      (bare ?a)
      (not (holding ?a))
      (not (leans ?a ?)))

    (rule (arm-empty)
      (not (holding ?))))

  ; An object's name as a target means: where the gripper holds it.
  (micro-tasks
    (GRASP (<ob>)
      (open <ob>) (raise) (make-room <ob>) (open <ob>)
      (turn-fingers <ob>) (align <ob>) (lower <ob>) (close) (raise) (square-up) (check-held <ob>))
    (RELEASE-AT (<target>)
      (raise) (square-up) (align <target>) (lower <target>) (release) (raise))

    (PICK-UP (<ob1>) (GRASP <ob1>))
    (LIFT (<ob1>) (GRASP <ob1>))
    (UNSTACK (<ob1> <ob2>) (GRASP <ob1>))
    (STACK (<ob1> <ob2>) (RELEASE-AT (on-top <ob1> <ob2>)))
    (PUT-DOWN (<ob1>) (RELEASE-AT (free-spot <ob1>)))
    (FREE (<ob1> <ob2>) (raise) (push-over <ob1>) (raise))))
