; Cubes are sorted into two trays by the shape of their marks: what is round at all on the right, what is straight on
; the left. (forall (?x OBJECT) (sorted ?x)) sorts whatever is there.
(domain sorting
  (extends "trays.scm")
  (objects (round TRAY) (round-1 SLOT) (round-2 SLOT)
           (straight TRAY) (straight-1 SLOT) (straight-2 SLOT))
  (facts (part-of round-1 round) (part-of round-2 round)
         (part-of straight-1 straight) (part-of straight-2 straight))
  (predicates
    (belongs (ob OBJECT) (tray TRAY))
    (sorted (ob OBJECT)))

  ; As in trays.scm, but into the tray that a cube belongs to.
  (operator PUT-INTO
    (params (<ob> OBJECT) (<slot> SLOT) (<tray> TRAY))
    (preconds (holding <ob>) (free <slot>) (part-of <slot> <tray>) (belongs <ob> <tray>))
    (effects (lies-at <ob> <slot>) (in <ob> <tray>) (sorted <ob>) (clear <ob>) (arm-empty)
             (del (holding <ob>)) (del (free <slot>))))
  (operator TAKE-OUT
    (params (<ob> OBJECT) (<slot> SLOT) (<tray> TRAY))
    (preconds (lies-at <ob> <slot>) (part-of <slot> <tray>) (clear <ob>) (arm-empty))
    (effects (holding <ob>) (free <slot>)
             (del (lies-at <ob> <slot>)) (del (in <ob> <tray>)) (del (sorted <ob>)) (del (clear <ob>)) (del (arm-empty))))

  (perception
    (fact (part-of round-1 round))
    (fact (part-of round-2 round))
    (fact (part-of straight-1 straight))
    (fact (part-of straight-2 straight))
    (fact (spot round-1 450 -210))
    (fact (spot round-2 450 -120))
    (fact (spot straight-1 450 210))
    (fact (spot straight-2 450 120))
    (fact (round-mark circle))

    (rule (belongs ?a round) (seen ?a ? ? ?) (round-mark ?a))
    (rule (belongs ?a straight) (seen ?a ? ? ?) (not (round-mark ?a)))
    (rule (sorted ?a) (in ?a ?tray) (belongs ?a ?tray))))
