#include "programs/chaos/fault.hpp"

namespace pizarra::chaos {

Datum fault_to_datum(const Fault& fault) {
  Datum when = list("after"_sym, fault.when.after_s);
  if (!fault.when.operation.empty()) {
    when = list("servo"_sym, fault.when.servo_state, Datum::symbol(fault.when.operation), fault.when.after_s);
  }
  return list(Datum::symbol(fault.kind), when, fault.what);
}

const std::vector<FaultClass>& fault_classes() {
  static const std::vector<FaultClass> classes = {
      {"network", "frames between agents and the board are delayed, or a connection stalls or is lost"},
      {"reply", "a reply is lost after its commit"},
      {"agent", "an agent is killed at a suspension point and comes back"},
      {"pause", "an agent or the board is held up at a suspension point"},
      {"board", "the board is killed, or loses its power, at a suspension point, and comes back"},
      {"disk", "the journal's disk is full, fails or is slow for a while"},
      {"clock", "the processes' clocks differ, drift and jump, and begin otherwise with each life"},
      {"frames", "the camera's frames are dropped, frozen, late or doubled"},
      {"sight", "marks are hidden from the camera, the image jumps, and looks tell of a cube that is not in view"},
      {"arm", "the arm's line is lost, its acknowledgements are late or come twice, or a motion stops short"},
      {"pendant", "somebody takes the arm's pendant and gives it back"},
      {"sensor", "the gripper's sensor is stuck"},
      {"slip", "what is held slips from the fingers"},
      {"misplace", "what is put down comes to lie off its place"},
      {"hand", "a hand pushes, places, stacks, steals, knocks, helps, holds in the way, takes away and brings back"},
      {"stop", "somebody stops the cell, or takes the arm in hand, for a while"},
      {"swap", "the eyes call two objects by each other's names"},
      {"alarm", "the arm's controller raises an alarm, which somebody resets after a while"},
      {"light", "the camera's light grows brighter or darker for a while"},
      {"bump", "somebody knocks against the camera or its pan-tilt unit, which stands otherwise from then on"},
  };
  return classes;
}

}  // namespace pizarra::chaos
