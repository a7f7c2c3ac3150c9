#pragma once

// An arm whose controller speaks ROS-Industrial's simple_message: over TCP (motion at 11000, state at 11002), or a
// CRS-F3 whose C500C runs the servers of crs-c500c-utils, over two serial lines of 115200 baud.
//
//   SimpleArm arm(executor, {.motion = motion_wire, .state = state_wire, .serial = true}, model);
//
// A move is a trajectory: the ends of its legs (route.hpp), each acknowledged before the next is sent, which is when
// read() comes. A controller that takes them one move at a time stands a moment at each. Nothing is sent twice: a point
// whose acknowledgement does not come ends the trajectory with a stop. A stop goes over the motion's line alone, before
// whatever is waited for there, and over a new connection where that line is lost.
//
// The protocol has neither servo nor alarm commands: take_control() asks whether motion is possible and says why not.
// A gripper is refused, unless a GrippingArm brings it. Joints are told in the order of the axes; a track is one of
// them where the controller has it (`track`). message_arm.hpp has what it shares with other drivers.
//
// How far it is proven: with the emulator of drivers/simulation/controllers/arms/ alone, over TCP frames and serial
// frames that are garbled; never with the C500C's servers. Their public source says:
// - Since January 2020 they make the moves, at 20 % of the arm's speed whatever a point asks for. So (speed 20) is the
//   honest setting.
// - A point whose number is not the next, or none of theirs, aborts the robot and is refused.
// - The number -4 leaves their online mode. Whether the arm brakes at once or ends its move is not said there. So a
//   number of nobody's is sent after it. -1 is refused and -2 accepted.
// - They tell neither emergency stop nor mode, never an error, and always that motion is possible. So only drives that
//   are off keep a move from being tried.

#include <deque>

#include "drivers/arm/route.hpp"
#include "drivers/arm/simple_message/message_arm.hpp"

namespace pizarra::arm {

class SimpleArm : public MessageArm {
 public:
  // The wires outlive it.
  SimpleArm(Executor& executor, SimpleWires wires, ArmModel model) : MessageArm(executor, wires, std::move(model)) {}
  Task<Result<void>> take_control() override;
  Task<Result<void>> start_move(std::vector<Joints> waypoints, double speed) override;
  Task<Result<void>> stop() override;
  Task<Result<ArmReading>> read() override;

 private:
  Task<Result<void>> greet() override;
  Result<std::optional<SimpleJoints>> angles_in(const SimpleMessage& message) const override;
  Result<void> able() const override;
  line::Dialogue::Fits reply_to(const SimpleMessage& message) const;
  Result<void> obeyed(const Result<std::string>& answer) const;
  Task<Result<void>> order(SimpleMessage message);
  Task<Result<void>> send_point(Leg leg);
  Task<void> go_on();

  std::deque<Leg> legs_;  // the one under way first
  double speed_ = 1;
  std::int32_t sequence_ = 0;
};

}  // namespace pizarra::arm
