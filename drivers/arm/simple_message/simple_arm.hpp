#pragma once

// An arm whose controller speaks ROS-Industrial's simple_message: over TCP (motion at 11000, state at 11002), or a
// CRS-F3 whose C500C runs the servers of crs-c500c-utils, over two serial lines of 115200 baud.
//
//   SimpleArm arm(executor, {.motion = motion_wire, .state = state_wire, .serial = true}, model);
//
// A move is a trajectory: the ends of its legs (route.hpp), each acknowledged before the next is sent, which is when
// read() comes. A controller that takes them one move at a time stands a moment at each. The state is streamed by the
// controller; one that has not been heard of for half a second is not known. Nothing is sent twice: a point whose
// acknowledgement does not come ends the trajectory with a stop. A stop goes over the motion's line alone, before
// whatever is waited for there, and over a new connection where that line is lost.
//
// The protocol has neither servo nor alarm commands: take_control() asks whether motion is possible and says why not.
// It has no gripper: one is refused, unless a GrippingArm brings it. Joints are told in the order of the axes. A track
// is one of them where the controller has it (`track`); else it reads where it is in the arm's `ready` pose,
// must stand there, and is not moved.
//
// The protocol does not say which arm it is: identify() refuses one whose controller tells an angle other than 0 for an
// axis that the arm's file does not have, and no other.
//
// How far it is proven: with the emulator of drivers/simulation/controllers/arms/ alone, over TCP frames and serial
// frames that are garbled; never with the C500C's servers, of which their public source says: since January 2020 they
// make the moves, at 20 % of the arm's speed whatever a point asks for, so that (speed 20) is the honest setting; a
// point whose number is not the next, or none of theirs, aborts the robot and is refused; -4 leaves their online mode,
// and whether the arm brakes at once or ends its move is not said there, so that it is sent a number of nobody's after
// it; -1 is refused and -2 accepted; they tell neither emergency stop nor mode, never an error, and always that motion
// is possible: with these servers only drives that are off keep a move from being tried.

#include <deque>

#include "drivers/arm/arm_driver.hpp"
#include "drivers/arm/route.hpp"
#include "drivers/arm/simple_message/simple_message.hpp"
#include "drivers/line/told_state.hpp"

namespace pizarra::arm {

struct SimpleWires {
  line::ByteWire& motion;
  line::ByteWire& state;
  bool serial = false;                              // the C500C's frames, or TCP's
  line::ByteOrder order = line::ByteOrder::little;  // of TCP's
  double sign = 1;                                  // -1 where the controller's angles count the other way round
  bool track = false;                               // it has the track among its joints, metres
};

class SimpleArm : public ArmDriver {
 public:
  // The wires outlive it.
  SimpleArm(Executor& executor, SimpleWires wires, ArmModel model);
  Task<Result<std::string>> identify() override;
  Task<Result<void>> take_control() override;
  Task<Result<void>> start_move(std::vector<Joints> waypoints, double speed) override;
  Task<Result<void>> stop() override;
  Task<Result<void>> start_gripper(double opening_mm) override;
  Task<Result<ArmReading>> read() override;

 private:
  static constexpr Duration opening_time = 3s;
  static constexpr Duration fresh = 500ms;
  static constexpr Duration starting_time = 300ms;  // until an arm that was sent somewhere is said to move
  static constexpr Duration stopping_time = 1s;     // until a line that was lost is there again for a stop

  std::string framed(const SimpleMessage& message) const;
  line::Dialogue::Fits reply_to(const SimpleMessage& message) const;
  Result<void> obeyed(const Result<std::string>& answer) const;
  Task<Result<void>> order(SimpleMessage message);
  Task<Result<void>> send_point(Leg leg);
  Task<void> go_on();
  Result<bool> hear(const std::string& octets);
  Result<void> possible() const;
  bool told(std::size_t axis) const { return model_.axes[axis].role != Role::track || wires_.track; }

  Executor& executor_;
  SimpleWires wires_;
  ArmModel model_;
  line::Dialogue motion_;
  line::Dialogue states_;
  line::ToldState told_;
  Joints joints_;
  SimpleStatus status_;
  std::optional<std::size_t> further_axis_;  // told by the controller, and none of the arm's
  std::deque<Leg> legs_;                     // the one under way first
  double speed_ = 1;
  std::int32_t sequence_ = 0;
  Time sent_at_{};
  bool moving_ = false;
  bool stopped_ = false;
  bool stopping_ = false;
  bool ordering_ = false;
  std::optional<Failure> why_stopped_;
};

}  // namespace pizarra::arm
