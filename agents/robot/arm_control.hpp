#pragma once

// Commands the motions of one arm: runs one at a time, and stops it. MotionWatch (motion_watch.hpp) watches a
// motion, and RestWatch (rest_watch.hpp) an arm at rest.
//
// A motion is stopped when no state of the arm comes (silence.hpp). The stop is repeated until the motion is seen to
// have ended: by the driver's stop() where it was not taken, and at every attempt to meet the controller anew.
//
// Lifecycle: constructed on the connection to the controller. A motion: take_in_hand(), then follow() or grip(), then
// the InHand goes.
//
//   const Result<InHand> in_hand = control.take_in_hand(request);     // or busy, disconnected
//   const Result<void> moved = co_await control.follow(reading.joints, waypoints, 1.0);
//
// Failures: busy, disconnected, stopped, fault, those of the Guard, and the driver's own.

#include <optional>

#include "agents/robot/arm_connection.hpp"
#include "agents/robot/guard.hpp"
#include "agents/robot/motion_watch.hpp"
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
  ArmControl(Executor& executor, ArmConnection& arm, const std::optional<WorkVolume>& room, Duration tell_period,
             ArmFacts& facts);

  const std::optional<Datum>& running() const { return running_; }
  // How many there were, with the one in hand.
  std::uint64_t motions() const { return motions_; }
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
  // on_stop_at_rest is called.
  void stop_at_once(Failure why);
  std::function<void()> on_stop_at_rest = [] {};
  bool was_stopped() const { return stop_requested_; }

 private:
  friend class InHand;
  Task<Result<void>> begin_grip(double opening_mm);
  Task<void> start_gripper(double opening_mm, std::optional<Result<void>>& begun, Event& answered);
  void guard(const arm::ArmReading& reading);
  Task<void> obey();
  std::unexpected<Failure> stopped() const;
  void let_go();

  Executor& executor_;
  ArmConnection& arm_;
  Guard guard_;
  MotionWatch watch_;
  std::optional<Datum> running_;
  Datum request_;
  Datum stop_asked_;
  std::uint64_t motions_ = 0;
  bool stop_requested_ = false;
  std::optional<Failure> why_stopped_;
  bool gripping_ = false;
  WaitList ended_;
  Job obeying_;
};

}  // namespace pizarra::robot
