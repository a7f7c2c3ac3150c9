#pragma once

// The motions of one arm: runs one at a time, stops it, and sees to it that the board knows where the arm is.
//
// A motion is stopped when no state of the arm comes (silence.hpp). The stop is repeated until the motion is seen to
// have ended: by the driver's stop() where it was not taken, and at every attempt to meet the controller anew.
//
// An arm that moves with no motion in hand (an order that came late, another's program) is stopped, and the board is
// told. An arm that somebody moves by the pendant is left alone.
//
// Lifecycle: constructed on the connection to the controller; keep_watch() runs beside it for as long as it lives
// (tells what changes by itself, connects again after the controller was away). A motion: take_in_hand(), then follow()
// or grip(), then the InHand goes.
//
//   const Result<InHand> in_hand = control.take_in_hand(request);     // or busy, disconnected
//   const Result<void> moved = co_await control.follow(reading.joints, waypoints, 1.0);
//
// Failures: busy, disconnected, stopped, fault, those of the Guard, and the driver's own.

#include <optional>

#include "agents/robot/arm_connection.hpp"
#include "agents/robot/guard.hpp"
#include "agents/robot/silence.hpp"
#include "blackboard/time/latch.hpp"

namespace pizarra::robot {

class ArmControl;

// While it lives, the arm is busy with its operation.
class [[nodiscard]] InHand {
 public:
  explicit InHand(ArmControl& control) : control_(&control) {}
  InHand(InHand&& other) noexcept : control_(std::exchange(other.control_, nullptr)) {}
  InHand& operator=(InHand&&) = delete;
  ~InHand();

 private:
  ArmControl* control_;
};

class ArmControl {
 public:
  static constexpr Duration poll_period = 20ms;  // at most
  static constexpr Duration reconnect_pause = 500ms;
  static constexpr Duration patience = 2s;  // with a controller that does not answer during a move or a grip

  ArmControl(runtime::AgentContext& context, ArmConnection& arm, const std::optional<WorkVolume>& room,
             double told_per_s, ArmFacts& facts);

  Task<void> keep_watch();
  const std::optional<Datum>& running() const { return running_; }
  // The ID of the request whose motion is in hand.
  const Datum& request() const { return request_; }
  // What is answered while it runs.
  Failure busy() const;

  // The motion of (request ID ROBOT OPERATION).
  Result<InHand> take_in_hand(const Datum& request);
  // Of what moves nothing, released or not.
  Result<InHand> occupy(Datum operation);
  // From where it was just read to stand through the waypoints (one at least) at `speed` 0..1; answers when the arm
  // stands again.
  Task<Result<void>> follow(arm::Joints from, std::vector<arm::Joints> waypoints, double speed);
  // Answers when the fingers stand, at the opening or on something between them.
  Task<Result<void>> grip(double opening_mm);
  // Answers when the arm stands and the motion it was in has failed with `stopped`, its subject what asked for that; at
  // rest it does nothing.
  Task<Result<void>> stop(Datum asked = {});
  // The reflex: brakes at once, without waiting for anything; the motion in hand fails with `why`. With none in hand
  // the arm is looked at at once, and what moves for nobody is stopped.
  void stop_at_once(Failure why);
  bool was_stopped() const { return stop_requested_; }

 private:
  friend class InHand;
  Task<Result<arm::ArmReading>> until_ended(bool gripper, Duration longest);
  void tell_where_due(Time& tell_at);
  Task<Result<void>> begin_grip(double opening_mm);
  Task<void> start_gripper(double opening_mm, std::optional<Result<void>>& begun, Event& answered);
  void guard(const arm::ArmReading& reading);
  Task<void> look();
  Task<void> look_at_rest();
  Task<void> tell_on_the_way();
  Task<void> obey();
  std::unexpected<Failure> stopped() const;
  void let_go();

  runtime::AgentContext& context_;
  ArmConnection& arm_;
  Guard guard_;
  ArmFacts& facts_;
  const Duration tell_period_;  // while something changes
  bool telling_ = false;        // on the way, and not yet acknowledged
  std::optional<Datum> running_;
  Datum request_;
  Datum stop_asked_;
  std::uint64_t motions_ = 0;
  bool stop_requested_ = false;
  std::optional<Failure> why_stopped_;
  bool gripping_ = false;
  WaitList look_now_;
  WaitList ended_;
  Job obeying_;
  Job on_the_way_;
};

}  // namespace pizarra::robot
