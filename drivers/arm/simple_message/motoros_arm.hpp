#pragma once

// A Motoman whose controller runs MotoROS (DX100, DX200, YRC1000; FS100, in the other byte order): motion at 50240,
// state at 50241.
//
//   MotorosArm arm(executor, {.motion = motion_wire, .state = state_wire}, model);
//
// A move is a trajectory: points with their moments and speeds (timed_points.hpp), from where the arm stands on. They
// are sent while the arm moves, each when the one before was taken; a controller that says it is busy is asked again.
// So the move is as fast as it was ordered and does not stand at waypoints; where points come too late the arm waits
// for them. Nothing else is sent twice: a point that is refused, or not answered, ends the trajectory with a stop.
//
// take_control() begins the trajectory mode, for which the controller resets alarms, switches the servos on and starts
// its job; who holds it by hand must let it go first. A stop goes over the motion's line, before whatever is waited for
// there, and over a new connection where that line is lost.
//
// It drives control group 0, the arm; a track of the arm's file reads as in the `ready` pose, must stand there, and is
// not moved. The protocol has no gripper and does not say which arm it is: identify() refuses one whose controller
// tells an angle other than 0 for an axis that the arm's file does not have, and no other.
//
// How far it is proven: with a controller of the tests that follows points as the published server does, in both byte
// orders, and with the emulator; never with a controller.

#include "drivers/arm/arm_driver.hpp"
#include "drivers/arm/simple_message/motoros_message.hpp"
#include "drivers/arm/simple_message/timed_points.hpp"
#include "drivers/line/told_state.hpp"

namespace pizarra::arm {

struct MotorosWires {
  line::ByteWire& motion;
  line::ByteWire& state;
  line::ByteOrder order = line::ByteOrder::little;
};

class MotorosArm : public ArmDriver {
 public:
  // The wires outlive it.
  MotorosArm(Executor& executor, MotorosWires wires, ArmModel model);
  Task<Result<std::string>> identify() override;
  Task<Result<void>> take_control() override;
  Task<Result<void>> start_move(std::vector<Joints> waypoints, double speed) override;
  Task<Result<void>> stop() override;
  Task<Result<void>> start_gripper(double opening_mm) override;
  Task<Result<ArmReading>> read() override;

 private:
  static constexpr Duration opening_time = 3s;
  static constexpr Duration fresh = 500ms;
  static constexpr Duration power_time = 8s;        // until the trajectory mode has begun
  static constexpr Duration starting_time = 300ms;  // until an arm that was sent somewhere is said to move
  static constexpr Duration stopping_time = 1s;     // until a line that was lost is there again for a stop
  static constexpr Duration busy_time = 5s;         // for which a controller may be busy with one point
  static constexpr Duration ask_again = 10ms;

  std::string framed(const SimpleMessage& message) const;
  Task<Result<MotorosReply>> command(std::int32_t what);
  Task<Result<void>> send_point(std::size_t index);
  Task<void> send_the_rest();
  Task<Result<void>> end_trajectory();
  Result<bool> hear(const std::string& octets);
  Result<void> able() const;
  std::string control_message(std::int32_t what);
  line::Dialogue::Fits reply_to(std::int32_t command, std::int32_t sequence) const;
  bool there() const;
  bool told(std::size_t axis) const { return model_.axes[axis].role != Role::track; }

  Executor& executor_;
  MotorosWires wires_;
  ArmModel model_;
  line::Dialogue motion_;
  line::Dialogue states_;
  line::ToldState told_;
  Joints joints_;
  SimpleStatus status_;
  std::optional<std::size_t> further_axis_;  // told by the controller, and none of the arm's
  std::int32_t commands_ = 0;
  std::vector<TimedPoint> points_;
  std::size_t sent_ = 0;  // points
  Time sent_at_{};
  bool ordering_ = false;  // a move is being begun
  bool moving_ = false;
  bool stopping_ = false;
  bool stopped_ = false;
  std::optional<Failure> why_stopped_;
  Job sending_;
};

}  // namespace pizarra::arm
