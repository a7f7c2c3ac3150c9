#pragma once

// The half that drivers over simple_message share: two lines to the controller, one for orders and one on which it
// tells its state; the arm that this state is of; and the motion in hand. SimpleArm and MotorosArm add how a move is
// made.
//
//   class MyArm : public MessageArm { ... };      // greet(), angles_in(), able(), and the moves
//
// A state that was not told for half a second is not known. The messages do not say which arm it is: identify() refuses
// one whose controller tells an angle other than 0 for an axis that the arm's file does not have, and no other. A track
// that the controller does not tell reads as in the arm's `ready` pose, must stand there, and is not moved. The
// protocol has no gripper.

#include "drivers/arm/arm_driver.hpp"
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

class MessageArm : public ArmDriver {
 public:
  Task<Result<std::string>> identify() override;
  Task<Result<void>> start_gripper(double opening_mm) override;

 protected:
  // The wires outlive it.
  MessageArm(Executor& executor, SimpleWires wires, ArmModel model);
  // Asks the controller, over the line for orders, whether it is there.
  virtual Task<Result<void>> greet() = 0;
  // The angles of the arm in a message; nothing where it tells none.
  virtual Result<std::optional<SimpleJoints>> angles_in(const SimpleMessage& message) const = 0;
  // Whether the arm would move now.
  virtual Result<void> able() const = 0;

  // The state is known, and nothing but `motion_possible` keeps the arm from moving.
  Result<void> sound() const;
  std::string framed(const SimpleMessage& message) const;
  // Places or speeds of the axes as the controller has them.
  SimpleJoints to_message(const Joints& axes) const;
  bool stands_at(const Joints& place) const;

  // Refuses a move that cannot be made; else the one before is forgotten.
  Result<void> begin_move(const std::vector<Joints>& waypoints, double speed);
  // The arm stands, and may still be about to move to where it was sent.
  bool may_begin() const { return !stopping_ && able() && executor_.now() - sent_at_ <= starting_time; }
  void end_move(bool too_early);
  // Goes before whatever is waited for on the line, and over a new connection where that is lost.
  Task<Result<std::string>> ask_to_stop(std::string request, line::Dialogue::Fits fits);
  // `off`: only its servos keep it from moving, where neither error, stop nor mode does.
  ArmReading reading(bool off) const;

  Executor& executor_;
  SimpleWires wires_;
  ArmModel model_;
  line::Dialogue motion_;
  line::Dialogue states_;
  line::ToldState told_;
  Joints joints_;
  SimpleStatus status_;
  Time sent_at_{};         // the newest point
  bool ordering_ = false;  // a move is being begun
  bool moving_ = false;
  bool stopping_ = false;
  bool stopped_ = false;
  std::optional<Failure> why_stopped_;

 private:
  static constexpr Duration opening_time = 3s;
  static constexpr Duration fresh = 500ms;
  static constexpr Duration starting_time = 300ms;  // until an arm that was sent somewhere is said to move
  static constexpr Duration reopening_time = 1s;    // until a line that was lost is there again for a stop

  bool told(std::size_t axis) const { return model_.axes[axis].role != Role::track || wires_.track; }
  Result<bool> hear(const std::string& octets);
  void take(const SimpleJoints& angles);

  std::optional<std::size_t> further_axis_;  // told by the controller, and none of the arm's
};

}  // namespace pizarra::arm
