#pragma once

// A Motoman whose controller runs MotoROS (DX100, DX200, YRC1000; FS100, in the other byte order): motion at 50240,
// state at 50241.
//
//   MotorosArm arm(executor, {.motion = motion_wire, .state = state_wire}, model);      // `order` for an FS100
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
// It drives control group 0, the arm, and no track. message_arm.hpp has what it shares with other drivers.
//
// How far it is proven: with a controller of the tests that follows points as the published server does, in both byte
// orders, and with the emulator; never with a controller.

#include "drivers/arm/simple_message/message_arm.hpp"
#include "drivers/arm/simple_message/motoros_message.hpp"
#include "drivers/arm/simple_message/timed_points.hpp"

namespace pizarra::arm {

class MotorosArm : public MessageArm {
 public:
  // The wires outlive it.
  MotorosArm(Executor& executor, SimpleWires wires, ArmModel model) : MessageArm(executor, wires, std::move(model)) {}
  Task<Result<std::string>> identify() override;
  Task<Result<void>> take_control() override;
  Task<Result<void>> release_control() override;
  Task<Result<void>> start_move(std::vector<Joints> waypoints, double speed) override;
  Task<Result<void>> stop() override;
  Task<Result<ArmReading>> read() override;

 private:
  static constexpr Duration power_time = 8s;  // until the trajectory mode has begun
  static constexpr Duration busy_time = 5s;   // for which a controller may be busy with one point
  static constexpr Duration ask_again = 10ms;

  Task<Result<void>> greet() override;
  Result<std::optional<SimpleJoints>> angles_in(const SimpleMessage& message) const override;
  Result<void> able() const override;
  Task<Result<MotorosReply>> command(std::int32_t what);
  Task<Result<void>> send_point(std::size_t index);
  Task<void> send_the_rest();
  Task<Result<void>> end_trajectory();
  std::string control_message(std::int32_t what);
  line::Dialogue::Fits reply_to(std::int32_t command, std::int32_t sequence) const;
  bool there() const;

  std::int32_t commands_ = 0;
  std::vector<TimedPoint> points_;
  std::size_t sent_ = 0;  // points
  Job sending_;
};

}  // namespace pizarra::arm
