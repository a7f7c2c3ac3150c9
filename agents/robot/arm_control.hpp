#pragma once

// The agent's hold on one arm: runs one motion at a time, stops it, and sees to it that the board knows
// where the arm is.
//
// Control is taken when the agent meets the controller for the first time and finds neither alarm nor lock there, and
// from then on only when somebody asks for it: a controller that had an alarm, lost its power or was locked keeps its
// servos off until then, and a motion is refused with its reason.
//
// A motion is stopped when no state of the arm comes (silence.hpp). The stop is repeated until the motion is seen to
// have ended: by the driver's stop() where it was not taken, and at every attempt to meet the controller anew.
//
// An arm that moves with no motion in hand (an order that came late, another's program) is stopped, and the board is
// told. An arm that somebody moves by the pendant is left alone.
//
// Lifecycle: find(), where what moves should stop before anybody may be obeyed; connect(); keep_watch() runs beside it
// for as long as it lives (tells what changes by itself, connects again after the controller was away). A motion:
// take_in_hand(), then follow() or grip(), then the InHand goes.
//
//   const Result<InHand> in_hand = control.take_in_hand(request);     // or busy, disconnected
//   const Result<void> moved = co_await control.follow(reading.joints, waypoints, 1.0);
//
// Failures: busy, disconnected, unknown-arm, stopped, fault, those of the Guard, and the driver's own.

#include <optional>

#include "agents/robot/arm_facts.hpp"
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
  static constexpr Duration patience = 2s;       // with a controller that does not answer during a move or a grip
  static constexpr Duration stopping_time = 5s;  // at most, until a stopped arm stands
  static constexpr Duration braking_time = 1s;   // what still moves after it is told to stop once more

  ArmControl(runtime::AgentContext& context, arm::ArmDriver& driver, const arm::ArmModel& model,
             const std::optional<Room>& room, double told_per_s, ArmFacts& facts)
      : context_(context),
        driver_(driver),
        model_(model),
        guard_(model, room),
        facts_(facts),
        tell_period_(std::chrono::duration_cast<Duration>(std::chrono::duration<double>(1 / told_per_s))),
        look_now_(context.executor),
        ended_(context.executor) {}

  // Asks which arm it is, and stops what moves: nobody is left who could answer for that move.
  Task<Result<arm::ArmReading>> find();
  // The same, and switches its servos on where the controller was not met before.
  Task<Result<void>> connect();
  // Resets alarms, switches servos on, releases brakes: what somebody asked for who knows why they were as they were.
  Task<Result<void>> get_control();
  // Switches its servos off; while it is released no motion is taken in hand.
  Task<Result<void>> release_control();
  // Whoever released it, in an earlier life too.
  void set_released(std::string by) { released_by_ = std::move(by); }
  const std::string& released_by() const { return released_by_; }
  Task<void> keep_watch();
  // The controller is away; keep_watch() looks for it.
  void lose(const Failure& why);

  bool connected() const { return connected_; }
  const arm::ArmModel& model() const { return model_; }
  const std::optional<Datum>& running() const { return running_; }
  // The ID of the request whose motion is in hand.
  const Datum& request() const { return request_; }
  // What is answered while it runs.
  Failure busy() const;

  // The motion of (request ID ROBOT OPERATION).
  Result<InHand> take_in_hand(const Datum& request);
  // Of what moves nothing, released or not.
  Result<InHand> occupy(Datum operation);
  Task<Result<arm::ArmReading>> read();
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
  Task<Result<void>> switch_on();
  Task<Result<arm::ArmReading>> until_ended(bool gripper, Duration longest);
  void tell_where_due(Time& tell_at);
  Task<Result<void>> begin_grip(double opening_mm);
  Task<void> start_gripper(double opening_mm, std::optional<Result<void>>& begun, Event& answered);
  Task<Result<void>> brake();
  Task<void> look();
  Task<void> look_at_rest();
  Task<void> tell_on_the_way();
  Task<void> obey();
  std::unexpected<Failure> stopped() const;
  void let_go();
  Duration longest_time(const arm::Joints& from, const std::vector<arm::Joints>& waypoints, double speed) const;

  runtime::AgentContext& context_;
  arm::ArmDriver& driver_;
  const arm::ArmModel& model_;
  Guard guard_;
  ArmFacts& facts_;
  const Duration tell_period_;  // while something changes
  bool telling_ = false;        // on the way, and not yet acknowledged
  bool known_ = false;          // the controller has said once that it is of this arm
  bool found_moving_ = false;   // and was stopped, which is not told yet
  bool connected_ = false;
  std::string why_lost_;
  std::string released_by_;  // empty: it is not
  std::optional<Datum> running_;
  Datum request_;
  Datum stop_asked_;
  std::uint64_t motions_ = 0;
  bool stop_requested_ = false;
  std::optional<Failure> why_stopped_;
  bool gripping_ = false;
  std::optional<Time> braked_at_;
  WaitList look_now_;
  WaitList ended_;
  Job obeying_;
  Job on_the_way_;
};

}  // namespace pizarra::robot
