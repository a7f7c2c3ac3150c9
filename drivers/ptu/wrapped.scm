; The commands of a pan-tilt unit's line.
(wrapped pan-tilt "PTU-46 command set"
  (functions PP TP PO TO PR TR PN PX TN TX PS TS PU TU PL TL PB TB PA TA L LE LD I S A H R RE RD RP RT DS DR DF E EE ED
             FV FT V))
