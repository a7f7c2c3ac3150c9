; Cubes on a table that has only numbered places: a cube may be put down where a place is free, and nowhere else. To
; swap two cubes, a free place or the top of a third cube is needed. All else is as in blocks.scm.
(domain numbered-places
  (extends "blocks.scm")
  (without on-table bare leans raised PICK-UP PUT-DOWN LIFT FREE)
  (types PLACE)
  (objects (place-1 PLACE) (place-2 PLACE) (place-3 PLACE) (place-4 PLACE))
  (predicates
    (at (ob OBJECT) (where PLACE))
    (free (where PLACE)))

  (operator TAKE
    (params (<ob> OBJECT) (<from> PLACE))
    (preconds (at <ob> <from>) (clear <ob>) (arm-empty))
    (effects (holding <ob>) (free <from>) (del (at <ob> <from>)) (del (clear <ob>)) (del (arm-empty))))
  (operator PUT
    (params (<ob> OBJECT) (<to> PLACE))
    (preconds (holding <ob>) (free <to>))
    (effects (at <ob> <to>) (clear <ob>) (arm-empty) (del (holding <ob>)) (del (free <to>))))

  (perception
    (constant half-pitch 50)            ; a cube lies at the place whose middle is less far away than this

    ; (spot PLACE X Y): where the middle of a cube at this place stands on the table.
    (fact (spot place-1 450 -200))
    (fact (spot place-2 450 -100))
    (fact (spot place-3 450 0))
    (fact (spot place-4 450 100))

    (rule (at ?a ?place)
      (seen ?a ? ?y ?z)
      (< ?z (* resting cube))
      (not (holding ?a))
      (not (on ?a ?))
      (spot ?place ? ?py)
      (< (abs (- ?y ?py)) half-pitch))
    (rule (free ?place) (spot ?place ? ?) (not (at ? ?place)))
    ; Neither flat on the table nor on a cube: not to be built on.
    (rule (askew ?a) (seen ?a ? ? ?z) (<= (* resting cube) ?z) (not (holding ?a)) (not (on ?a ?)))
    (rule (clear ?a) (seen ?a ? ? ?) (not (holding ?a)) (not (askew ?a)) (not (on ? ?a))))

  (micro-tasks
    (TAKE (<ob> <from>) (GRASP <ob>))
    (PUT (<ob> <to>) (RELEASE-AT (at-place <ob> <to>)))))
