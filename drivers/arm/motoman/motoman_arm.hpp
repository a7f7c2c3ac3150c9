#pragma once

// A Motoman arm as an ArmDriver, over whichever MotomanLink reaches its controller. The arm's file must say the
// (pulses-per-turn ...) of every axis.
//
//   MotomanArm arm(executor, link, model);
//
// A move goes as few targets, one after another (route.hpp): straight lines as linear moves, the rest in pulses; curves
// are many short ones, and the arm stands a moment between them. Each is ordered by read(), once the one before has
// ended, so that an arm which nobody asks goes no further than its target. A linear move is reckoned from where the
// controller says its own tool is, so that neither its tool's length nor its base frame's origin need be known; the
// axes of that frame must be the cell's.
//
// Every target is gone to exactly once, whatever the line loses or repeats. Where an answer does not come, the driver
// looks (does the arm run? is it there?) before it orders the target again, and orders no other before. That holds
// while it is the arm's only commander, and no datagram on the line is older than the target in hand: the protocol
// cannot mark old ones. An order that the network delayed for longer remains a danger. While the arm moves the
// controller refuses it. While the arm stands the order is carried out: read() sees an arm in remote mode move although
// nothing is in hand, and holds it, so it moves no longer than from one reading to the next. Between two targets of a
// move it is taken for the way to the second one, and the move ends where it leads, with `stopped`.
//
// stop() is the controller's hold, which stays until control is taken (motoman_control.hpp) or a move is started. The
// gripper is held by a job of the controller to variables: D000 the opening wanted, D001 the opening measured, both
// micrometres, D002 1 while the fingers move.
//
// Nothing asked for here says which arm it is: identify() refuses one that has pulses on an axis that the arm's file
// does not have, and no other.
//
// How far it is proven: docs/write-a-driver.md; never with hardware.

#include <deque>

#include "blackboard/time/executor.hpp"
#include "drivers/arm/arm_driver.hpp"
#include "drivers/arm/motoman/motoman_control.hpp"
#include "drivers/arm/route.hpp"

namespace pizarra::arm {

class MotomanArm : public ArmDriver {
 public:
  // The link outlives it.
  MotomanArm(Executor& executor, MotomanLink& link, ArmModel model)
      : executor_(executor), link_(link), control_(executor, link), model_(std::move(model)) {}
  Task<Result<std::string>> identify() override;
  Task<Result<void>> take_control() override;
  Task<Result<void>> release_control() override { return control_.release(); }
  Task<Result<void>> start_move(std::vector<Joints> waypoints, double speed) override;
  Task<Result<void>> stop() override;
  Task<Result<void>> start_gripper(double opening_mm) override;
  Task<Result<ArmReading>> read() override;
  Duration longest_silence() const override { return link_.longest_silence(); }

 private:
  static constexpr Duration opening_time = 3s;
  static constexpr Duration starting_time = 300ms;  // at most, until an arm that was ordered to move runs
  static constexpr Duration fresh = 20ms;
  static constexpr int most_orders = 25;                    // of one target that the line loses
  static constexpr std::uint64_t reads_of_an_opening = 10;  // while the fingers stand

  struct Seen {
    MotomanStatus status;
    Joints joints;
    Time at;
  };

  struct Line {
    MotomanPose target;
    double length_mm;
  };

  Task<Result<Seen>> look();
  // The last look, where it is no older than `fresh`.
  Task<Result<Seen>> look_lately();
  Task<Result<void>> look_at_gripper();
  Task<Result<void>> order(Leg leg, Joints from);
  Task<Result<void>> order_once(const Leg& leg, const std::optional<Line>& line);
  Task<Result<Line>> line_to(Joints to, Joints from);
  Task<Result<void>> go_on(const Seen& seen);
  Task<void> hold_if_nobody_ordered(MotomanStatus status);
  void end_move(std::optional<Failure> why_stopped);
  Joints joints_of(const MotomanPulses& pulses) const;
  MotomanPulses pulses_of(const Joints& joints) const;

  Executor& executor_;
  MotomanLink& link_;
  MotomanControl control_;
  ArmModel model_;

  std::optional<Seen> seen_;  // nothing was commanded since

  // The move in hand.
  std::deque<Leg> legs_;  // the one under way first
  double speed_ = 1;
  Time ordered_at_{};
  bool moving_ = false;
  bool ordering_ = false;  // somebody waits for the controller's word on an order
  bool stopping_ = false;
  bool stopped_ = false;
  std::optional<Failure> why_stopped_;

  double opening_mm_ = 0;
  bool gripping_ = false;
  Time gripping_since_{};
  std::uint64_t reads_ = 0;
};

}  // namespace pizarra::arm
