; Cubes are put into trays, each of some slots that take one cube. On the rest of the table all is as in blocks.scm.
;
; A domain that extends this one says which trays there are: objects (TRAY-NAME TRAY) and (SLOT-NAME SLOT), the facts
; (part-of SLOT TRAY) among the domain's and perception's facts, and where each slot is, (spot SLOT X Y).
(domain trays
  (extends "blocks.scm")
  (types TRAY SLOT)
  (predicates
    (part-of (slot SLOT) (tray TRAY))
    (lies-at (ob OBJECT) (slot SLOT))
    (in (ob OBJECT) (tray TRAY))
    (free (slot SLOT)))

  (operator PUT-INTO
    (params (<ob> OBJECT) (<slot> SLOT) (<tray> TRAY))
    (preconds (holding <ob>) (free <slot>) (part-of <slot> <tray>))
    (effects (lies-at <ob> <slot>) (in <ob> <tray>) (clear <ob>) (arm-empty)
             (del (holding <ob>)) (del (free <slot>))))
  (operator TAKE-OUT
    (params (<ob> OBJECT) (<slot> SLOT) (<tray> TRAY))
    (preconds (lies-at <ob> <slot>) (part-of <slot> <tray>) (clear <ob>) (arm-empty))
    (effects (holding <ob>) (free <slot>)
             (del (lies-at <ob> <slot>)) (del (in <ob> <tray>)) (del (clear <ob>)) (del (arm-empty))))

  (perception
    (constant half-slot 40)             ; a cube lies in the slot whose middle is less far away than this

    (rule (lies-at ?a ?slot)
      (seen ?a ?x ?y ?z)
      (< ?z (* resting cube))
      (not (holding ?a))
      (not (on ?a ?))
      (spot ?slot ?sx ?sy)
      (< (abs (- ?y ?sy)) (+ half-slot (if (was (lies-at ?a ?slot)) 3 -3)))
      ; The mark is half a cube before the middle.
      (< (abs (- (- ?x (* 0.5 cube)) ?sx)) (+ half-slot (if (was (lies-at ?a ?slot)) 13 7))))
    (rule (in ?a ?tray) (lies-at ?a ?slot) (part-of ?slot ?tray))
    (rule (free ?slot) (spot ?slot ? ?) (not (lies-at ? ?slot)))
    (rule (on-table ?a)                 ; what lies in a slot is taken out of it, and is not picked up
      (seen ?a ? ? ?z)
      (< ?z (* resting cube))
      (not (holding ?a))
      (not (on ?a ?))
      (not (leans ?a ?))
      (not (lies-at ?a ?))))

  (micro-tasks
    (PUT-INTO (<ob> <slot> <tray>) (RELEASE-AT (at-place <ob> <slot>)))
    (TAKE-OUT (<ob> <slot> <tray>) (GRASP <ob>))))
