; The size of the vendor's communication library for a Motoman arm, and the operations of a robot agent that wrap it.
(wrapped robot "Motoman arm library"
  (operations get-status do-action retract extend turn move-h move-v turn-ef turn-wrist home ready speed learn goto
              gripper monitor finish)
  (functions (library 82)))
