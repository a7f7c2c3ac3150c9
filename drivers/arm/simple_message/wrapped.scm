; What the vendor's programming interface of a CRS arm offers, by its classes, and which operations of a robot agent
; stand for it.
(wrapped robot "CRS arm interface"
  (operations get-status do-action retract extend turn move-h move-v turn-ef turn-wrist home ready speed learn goto
              gripper monitor finish)
  (functions (CRSRobot 126) (CRSV3File 9) (CRSLocation 13) (CRSPath 5) (CRSRemote 29)))
