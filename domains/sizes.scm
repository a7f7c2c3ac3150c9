; Cubes of several sizes on three places: a larger one never comes onto a smaller one. To move a tower of three is the
; puzzle of Hanoi: seven moves, of two operations each. All else is as in numbered-places.scm.
;
; A cell says which cube has which size: (cube circle (size 40) ...). The rules know it as (edge circle 40).
(domain sizes
  (extends "numbered-places.scm")
  (without place-4)
  (predicates
    (fits (upper OBJECT) (lower OBJECT)))

  (operator STACK
    (params (<ob1> OBJECT) (<ob2> OBJECT))
    (preconds (clear <ob2>) (holding <ob1>) (fits <ob1> <ob2>))
    (effects (arm-empty) (clear <ob1>) (on <ob1> <ob2>) (del (clear <ob2>)) (del (holding <ob1>))))

  (perception
    (fact (spot place-1 450 -150))
    (fact (spot place-2 450 0))
    (fact (spot place-3 450 150))

    (rule (fits ?a ?b)
      (seen ?a ? ? ?) (edge ?a ?edge)
      (seen ?b ? ? ?) (edge ?b ?below)
      (/= ?a ?b)
      (<= ?edge ?below))

    (rule (holding ?o)
      (gripper ?opening)
      (edge ?o ?edge)
      (< (abs (- ?opening ?edge)) (if (was (holding ?)) 9 7))
      (grip ?gx ?gy ?gz)
      (seen ?o ?x ?y ?z)
      (< (abs (- ?x ?gx)) (if (was (holding ?o)) 36 32))
      (< (abs (- ?y ?gy)) (if (was (holding ?o)) 22 18))
      (< (abs (- ?z ?gz)) (* (if (was (holding ?o)) 0.8 0.73) ?edge)))
    (rule (holding ?o)
      (unseen ?o)
      (was (holding ?o))
      (edge ?o ?edge)
      (gripper ?opening)
      (< (abs (- ?opening ?edge)) 9))

    ; A mark is half an edge before the middle of its cube.
    (rule (on ?a ?b)
      (seen ?a ?ax ?ay ?az) (edge ?a ?edge)
      (not (holding ?a))
      (seen ?b ?bx ?by ?bz) (edge ?b ?below)
      (/= ?a ?b)
      (not (holding ?b))
      (< (abs (- (- ?az ?bz) (* 0.5 (+ ?edge ?below)))) (if (was (on ?a ?b)) 16 12))
      (< (abs (- ?ay ?by)) (+ (* 0.5 ?below) (if (was (on ?a ?b)) 4 1)))
      (< (abs (- (- ?ax (* 0.5 ?edge)) (- ?bx (* 0.5 ?below)))) (+ (* 0.5 ?below) (if (was (on ?a ?b)) 10 6))))))
