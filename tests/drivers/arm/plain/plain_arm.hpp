#pragma once

// Controllers of a few lines each, written from the protocols' documents, which share no code with the emulated ones:
// what a driver is tried on that must not be right only because driver and emulator are wrong alike.
//
// Each has an arm that stands in its file's `ready` pose and that says of itself, once ordered to move, that it moves,
// until it is told to stop. It may fall silent about its state and go on hearing orders.

namespace pizarra::arm {

struct PlainArm {
  bool moving = false;
  bool silent = false;
  bool deaf = false;  // to stops
  int stops = 0;      // that it was told

  void move() { moving = true; }
  void stop() {
    ++stops;
    moving = moving && deaf;
  }
};

}  // namespace pizarra::arm
