; The size of the vendor's programming interface for a CRS arm, class by class, and the operations of a robot agent that
; wrap it.
(wrapped robot "CRS arm interface"
  (operations get-status do-action retract extend turn move-h move-v turn-ef turn-wrist home ready speed learn goto
              gripper monitor finish)
  (functions (CRSRobot 126) (CRSV3File 9) (CRSLocation 13) (CRSPath 5) (CRSRemote 29)))
