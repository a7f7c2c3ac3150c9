#include "agents/robot/arm_control.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "agents/robot/motion.hpp"
#include "drivers/arm/meeting.hpp"
#include "lisp/writer.hpp"

namespace pizarra::robot {

namespace {

constexpr double arrived = 0.5;          // degrees or mm: how far a controller may report from where it was sent
constexpr Duration gripping_time = 20s;  // at most

// The driver's refusal for want of control, with the operation that asks for it.
std::unexpected<Failure> refused(Failure why) {
  if (why.symbol == "not-in-control") why.sentence += "; (get-control) takes it back";
  return std::unexpected(std::move(why));
}

}  // namespace

ArmControl::ArmControl(Executor& executor, ArmConnection& arm, const std::optional<WorkVolume>& room,
                       Duration tell_period, ArmFacts& facts)
    : executor_(executor),
      arm_(arm),
      guard_(arm.model(), room),
      watch_(executor, arm, facts, tell_period),
      ended_(executor) {
  arm_.on_reading = [this](const arm::ArmReading& reading) { guard(reading); };
}

InHand::~InHand() {
  if (control_ != nullptr) control_->let_go();
}

Result<InHand> ArmControl::take_in_hand(const Datum& request) {
  const std::string& released_by = arm_.released_by();
  if (!released_by.empty()) {
    return refused({"not-in-control", released_by + " released control of the arm", Datum::symbol(released_by), {}});
  }
  Result<InHand> in_hand = occupy(request[3]);
  if (in_hand) request_ = request[1];
  return in_hand;
}

Result<InHand> ArmControl::occupy(Datum operation) {
  if (!arm_.is_there()) return fail("disconnected", arm_.why_lost());
  if (running_) return fail(busy());
  running_ = std::move(operation);
  ++motions_;
  request_ = Datum();
  stop_requested_ = false;
  stop_asked_ = Datum();
  why_stopped_.reset();
  guard_.begin();
  return InHand(*this);
}

Failure ArmControl::busy() const {
  return {"busy", fmt::format("the arm is doing {}", write(*running_)), *running_, {}};
}

void ArmControl::let_go() {
  running_.reset();
  gripping_ = false;
  ended_.wake_all();
}

void ArmControl::guard(const arm::ArmReading& reading) {
  if (!running_) return;
  std::optional<Failure> wrong = guard_.look(reading.at.value_or(executor_.now()), reading);
  if (wrong) stop_at_once(std::move(*wrong));
}

Task<Result<void>> ArmControl::follow(arm::Joints from, std::vector<arm::Joints> waypoints, double speed) {
  const arm::Joints target = waypoints.back();
  const Duration longest = longest_time(arm_.model(), from, waypoints, speed);
  if (stop_requested_) co_return stopped();
  std::function<void(Failure)> on_silence = [this](Failure why) { stop_at_once(std::move(why)); };
  const Silence silence(executor_, arm_.driver(), std::move(on_silence));
  const Result<void> started = co_await arm_.driver().start_move(std::move(waypoints), speed);
  if (!started) co_return refused(started.error());
  // A stop may have come before there was anything to stop.
  if (stop_requested_) {
    const Result<void> halting = co_await arm_.brake();
    if (!halting) co_return halting;
  }
  const Result<arm::ArmReading> ended = co_await watch_.until_ended(MotionWatch::Of::arm, longest);
  if (!ended) co_return fail(ended);
  if (stop_requested_) co_return stopped();
  if (ended->stopped) {
    if (ended->why_stopped) co_return fail(*ended->why_stopped);
    co_return fail("stopped", "the controller ended the motion early, as after a collision", *running_);
  }
  for (std::size_t axis = 0; axis < target.size(); ++axis) {
    if (std::abs(ended->joints[axis] - target[axis]) <= arrived) continue;
    co_return fail(
        "fault", fmt::format("axis {} ended at {:.2f} instead of {:.2f}", axis + 1, ended->joints[axis], target[axis]),
        to_datum(axis + 1));
  }
  co_return {};
}

// A gripper may be a device of its own, and slow: the arm is looked at meanwhile.
Task<Result<void>> ArmControl::begin_grip(double opening_mm) {
  std::optional<Result<void>> begun;
  Event answered(executor_);
  const Job beginning = executor_.spawn(start_gripper(opening_mm, begun, answered));
  watch_.begin();
  while (!begun) {
    const Time deadline = executor_.now() + MotionWatch::poll_period;
    const bool now = co_await answered.wait(deadline);
    if (now) break;
    const Result<arm::ArmReading> reading = co_await arm_.read();
    if (reading) watch_.tell_where_due();
  }
  co_return *begun;
}

Task<void> ArmControl::start_gripper(double opening_mm, std::optional<Result<void>>& begun, Event& answered) {
  begun = co_await arm_.driver().start_gripper(opening_mm);
  answered.set();
}

Task<Result<void>> ArmControl::grip(double opening_mm) {
  gripping_ = true;
  if (stop_requested_) co_return stopped();
  const Result<void> started = co_await begin_grip(opening_mm);
  if (!started) co_return refused(started.error());
  const Result<arm::ArmReading> ended = co_await watch_.until_ended(MotionWatch::Of::gripper, gripping_time);
  if (!ended) co_return fail(ended);
  if (stop_requested_) co_return stopped();
  co_return {};
}

std::unexpected<Failure> ArmControl::stopped() const {
  if (why_stopped_) return std::unexpected(*why_stopped_);
  return fail("stopped", "the motion was stopped before its end", stop_asked_);
}

void ArmControl::stop_at_once(Failure why) {
  if (!running_) on_stop_at_rest();
  if (!running_ || why_stopped_) return;
  stop_requested_ = true;
  why_stopped_ = std::move(why);
  obeying_ = executor_.spawn(obey());
}

// Again and again, while what is to end has not.
Task<void> ArmControl::obey() {
  const std::uint64_t motion = motions_;
  Result<void> obeyed = co_await stop();
  while (!obeyed) {
    arm_.lose(obeyed.error());
    co_await sleep(executor_, MotionWatch::poll_period);
    if (!running_ || motions_ != motion) co_return;
    obeyed = co_await stop();
  }
}

Task<Result<void>> ArmControl::stop(Datum asked) {
  const std::uint64_t motion = motions_;
  stop_requested_ = running_.has_value();
  stop_asked_ = std::move(asked);
  const Result<void> stopping = co_await arm_.brake();
  if (!stopping) co_return stopping;
  if (gripping_) {
    // Fingers stop by being sent to where they are.
    const Result<arm::ArmReading> reading = co_await arm_.read();
    if (!reading) co_return fail(reading);
    if (!reading->gripper_trouble) {
      const double opening_mm = reading->opening_mm;
      const Result<void> held = co_await arm_.driver().start_gripper(opening_mm);
      // A gripper that dies just now is not the arm.
      const Result<arm::ArmReading> after = co_await arm_.read();
      const bool gripper_is_gone = after && after->gripper_trouble;
      if (!held && !gripper_is_gone) co_return held;
    }
  }
  const Time deadline = executor_.now() + arm::stopping_time;
  while (running_ && motions_ == motion) {
    const bool woken = co_await ended_.wait(deadline);
    if (!woken) co_return fail("timeout", "the arm was told to stop and has not", *running_);
  }
  co_return {};
}

}  // namespace pizarra::robot
