#pragma once

// The primitive motions that a domain's micro-tasks are made of. Of the gripper:
//
//   (open OBJECT)         open the gripper as wide as the neighbours of OBJECT leave room
//   (close)               close it; fails `missed` where nothing is between the fingers
//   (release)             open it just enough to let go
//
// Of the arm, by the servo and its states:
//
//   (raise)               up to the height for travelling (servo state 0)
//   (align TARGET)        at travel height, over the target (servo states 0-2)
//   (lower TARGET)        down onto the target (servo states 0-4)
//
// Against what stands too close or askew:
//
//   (make-room OBJECT)    push OBJECT out of its row where neighbours leave the fingers no room
//   (push-over OBJECT)    push OBJECT, which lies askew, off what it leans on, towards the camera
//
// Of the wrist, and a look at the fingers:
//
//   (turn-fingers OBJECT) turn the wrist as OBJECT's face is turned, so that the fingers lie on its sides
//   (square-up)           turn it back, so that what is held faces the camera
//   (check-held OBJECT)   fails `missed` where the eyes do not see OBJECT between the fingers
//
// A TARGET says where the gripper, or what it holds, is to be:
//
//   OBJECT                     the gripper around it
//   (on-top OBJECT LOWER)      the held OBJECT one cube height above LOWER
//   (free-spot OBJECT)         the held OBJECT on the table, where there is room for it
//   (at-place OBJECT PLACE)    the held OBJECT on the table at a (spot PLACE X Y) of the perception section
//
// A free spot is off all spots of the perception section where possible.
//
// `close` and `release` change what is held: until the first of them an operation's preconditions must go on holding.

#include "lisp/forms/micro_tasks.hpp"

namespace pizarra::coordinator {

inline forms::Motions coordinator_motions() {
  return {.primitives = {{"open", 1},
                         {"close", 0},
                         {"release", 0},
                         {"raise", 0},
                         {"make-room", 1},
                         {"push-over", 1},
                         {"turn-fingers", 1},
                         {"square-up", 0},
                         {"align", 1},
                         {"lower", 1},
                         {"check-held", 1}},
          .aimed = {"align", "lower"},
          .targets = {{"on-top", 2}, {"free-spot", 1}, {"at-place", 2}}};
}

}  // namespace pizarra::coordinator
