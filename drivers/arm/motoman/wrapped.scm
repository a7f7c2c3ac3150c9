; What the vendor's communication library of a Motoman arm offers, and which operations of a robot agent stand for it.
(wrapped robot "Motoman arm library"
  (operations get-status do-action retract extend turn move-h move-v turn-ef turn-wrist home ready speed learn goto
              gripper monitor finish)
  (functions (library 82)))
