#pragma once

// The controller of a Motoman arm behind whichever server shows it: status words, positions in pulses and millimetres,
// D variables, switches and moves, in the controller's own units. It refuses what its cabinet would refuse; a server
// words that in its codes.
//
//   MotomanController controller(cabinet);
//   const Refusal refusal = co_await controller.move_joints(pulses, 0.5);
//
// One move at a time; the next is refused while the arm runs. Its base frame has its origin at the height of axis 2 and
// its tool ends at the flange, so that who takes them for the cell's is wrong by that much.
//
// D000 is the opening that the gripper's job holds the fingers to, D001 the opening measured, micrometres; D002 is 1
// while they move.

#include <map>

#include "drivers/arm/motoman/motoman_link.hpp"
#include "drivers/simulation/controllers/arms/arm_cabinet.hpp"

namespace pizarra::simulation {

class MotomanController {
 public:
  static constexpr int variables = 100;

  // The cabinet outlives it.
  explicit MotomanController(ArmCabinet& cabinet) : cabinet_(cabinet) {}
  ArmCabinet& cabinet() { return cabinet_; }

  struct Words {
    std::uint32_t modes;
    std::uint32_t states;
  };
  Task<Words> status();
  Task<arm::MotomanPulses> pulses();
  Task<arm::MotomanPose> pose();
  // The target's last axes are taken where the arm has so many.
  Task<Refusal> move_joints(arm::MotomanPulses target, double part);
  Task<Refusal> move_straight(arm::MotomanPose target, double mm_s);
  // Not straight: as the axes take it there.
  Task<Refusal> move_joints_to(arm::MotomanPose target, double part);
  arm::MotomanPose pose_of(const arm::MotomanPulses& pulses) const;
  // By so much from here, in the base frame or the tool's.
  static arm::MotomanPose moved_on(const arm::MotomanPose& from, const arm::MotomanPose& by, bool in_tool);
  // 1 a step, 2 a cycle, 3 on and on. False where it is none of these.
  bool set_cycle(std::uint32_t cycle);
  // Of a D variable, 0 to 99.
  Task<std::int32_t> variable(int number);
  // A command that moves the fingers is refused as a move is.
  Task<Refusal> set_variable(int number, std::int32_t value);

 private:
  ArmCabinet& cabinet_;
  std::map<int, std::int32_t> variables_;
  std::uint32_t cycle_ = 3;
};

// The code for it that all servers have in common (refusal_codes.hpp); of what is out of range each has its own.
std::uint16_t motoman_code(Refusal refusal);

}  // namespace pizarra::simulation
