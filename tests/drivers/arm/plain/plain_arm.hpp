#pragma once

// Controllers of a few lines each, written from the protocols' documents, which share no code with the emulated ones:
// what a driver is tried on that must not be right only because driver and emulator are wrong alike.
//
// Each has an arm that stands in its file's `ready` pose. Once ordered to move it says that it moves, until it is told
// to stop or put where it was sent. It may fall silent about its state and go on hearing orders.

#include "drivers/arm/arm_model.hpp"

namespace pizarra::arm {

struct PlainArm {
  bool moving = false;
  bool silent = false;
  bool deaf = false;  // to stops
  int stops = 0;      // that it was told
  Joints at = {};     // degrees and mm
  Joints sent = {};   // where it was sent last

  // Where it was sent: there it stands now.
  void arrive() {
    at = sent;
    moving = false;
  }
  void move() { moving = true; }
  void stop() {
    ++stops;
    moving = moving && deaf;
  }
};

}  // namespace pizarra::arm
