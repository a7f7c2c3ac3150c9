#include "agents/robot/arm_control.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "agents/robot/motion.hpp"
#include "blackboard/time/pace.hpp"
#include "drivers/arm/meeting.hpp"
#include "lisp/writer.hpp"

namespace pizarra::robot {

namespace {

constexpr double arrived = 0.5;          // degrees or mm: how far a controller may report from where it was sent
constexpr Duration gripping_time = 20s;  // at most
constexpr Duration full_telling = 1s;    // a board that restarted has forgotten what it was told

// The driver's refusal for want of control, with the operation that asks for it.
std::unexpected<Failure> refused(Failure why) {
  if (why.symbol == "not-in-control") why.sentence += "; (get-control) takes it back";
  return std::unexpected(std::move(why));
}

}  // namespace

ArmControl::ArmControl(runtime::AgentContext& context, ArmConnection& arm, const std::optional<WorkVolume>& room,
                       double told_per_s, ArmFacts& facts)
    : context_(context),
      arm_(arm),
      guard_(arm.model(), room),
      facts_(facts),
      tell_period_(std::chrono::duration_cast<Duration>(std::chrono::duration<double>(1 / told_per_s))),
      look_now_(context.executor),
      ended_(context.executor) {
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

Task<void> ArmControl::look() {
  if (!arm_.is_there()) {
    const Result<void> again = co_await arm_.connect();
    if (!again) arm_.lose(again.error());
  } else {
    co_await look_at_rest();
  }
  // A motion that began meanwhile tells for itself.
  if (running_) co_return;
  const Result<void> told = co_await facts_.tell();
  if (!told) facts_.forget_told();
}

Task<void> ArmControl::look_at_rest() {
  const std::uint64_t motion = motions_;
  const Result<arm::ArmReading> reading = co_await arm_.driver().read();
  // Of a motion that began meanwhile it says nothing that is wrong.
  if (motions_ != motion) co_return;
  if (!reading) {
    arm_.lose(reading.error());
    co_return;
  }
  facts_.set_reading(arm_.model(), *reading);
  const bool stray = arm::moves_for_nobody(*reading) && !arm_.is_braking();
  if (!stray) co_return;
  facts_.set_arm("stopped", "MOVED_BY_ITSELF");
  const Result<void> braked = co_await arm_.brake();
  if (!braked) arm_.lose(braked.error());
}

Task<void> ArmControl::keep_watch() {
  Pace pace(context_.executor, tell_period_);
  Time told = context_.executor.now();
  Time next = told;
  bool early = false;
  while (true) {
    if (!early) {
      const Duration beat = pace.pause();
      next = context_.executor.now() + (arm_.is_there() ? beat : reconnect_pause);
    }
    early = co_await look_now_.wait(next);
    const Time now = context_.executor.now();
    if (now - told >= full_telling) {
      facts_.forget_told();
      told = now;
    }
    if (!running_) co_await look();
  }
}

void ArmControl::guard(const arm::ArmReading& reading) {
  if (!running_) return;
  std::optional<Failure> wrong = guard_.look(reading.at.value_or(context_.executor.now()), reading);
  if (wrong) stop_at_once(std::move(*wrong));
}

// Polls until the arm (or the gripper) stands, telling on the way.
Task<Result<arm::ArmReading>> ArmControl::until_ended(bool gripper, Duration longest) {
  const Time begun = context_.executor.now();
  Time heard = begun;
  Pace pace(context_.executor, std::min(poll_period, tell_period_ / 2));
  Time tell_at = begun + tell_period_;
  while (true) {
    const Duration pause = pace.pause();
    co_await sleep(context_.executor, pause);
    const Result<arm::ArmReading> reading = co_await arm_.read();
    const Time now = context_.executor.now();
    if (!reading) {
      if (now - heard < patience) continue;
      arm_.lose(reading.error());
      co_return fail(reading);
    }
    const bool unknown = gripper && reading->gripper_trouble;
    if (unknown && now - heard < patience) continue;
    if (unknown) co_return fail(*reading->gripper_trouble);
    heard = now;
    const bool moving = gripper ? reading->gripper_moving : reading->moving;
    if (!moving) co_return reading;
    if (now - begun > longest) {
      const Result<void> halting = co_await arm_.brake();
      if (!halting) arm_.lose(halting.error());
      co_return fail("fault", fmt::format("the motion did not end within {:.1f} s", longest.count() / 1e6));
    }
    tell_where_due(tell_at);
  }
}

// Where the controller was late with something new, it is told as soon as it comes.
void ArmControl::tell_where_due(Time& tell_at) {
  const Time now = context_.executor.now();
  if (now < tell_at || !facts_.changed()) return;
  tell_at = std::max(tell_at + tell_period_, now);
  // A board that is slow is told the newest when it is back, and the looking at the arm does not wait for it.
  if (!telling_) on_the_way_ = context_.executor.spawn(tell_on_the_way());
}

// A board that is away misses this; the end of the motion is told surely.
Task<void> ArmControl::tell_on_the_way() {
  telling_ = true;
  const Result<void> told = co_await facts_.tell();
  if (!told) facts_.forget_told();
  telling_ = false;
}

Task<Result<void>> ArmControl::follow(arm::Joints from, std::vector<arm::Joints> waypoints, double speed) {
  const arm::Joints target = waypoints.back();
  const Duration longest = longest_time(arm_.model(), from, waypoints, speed);
  if (stop_requested_) co_return stopped();
  std::function<void(Failure)> on_silence = [this](Failure why) { stop_at_once(std::move(why)); };
  const Silence silence(context_.executor, arm_.driver(), std::move(on_silence));
  const Result<void> started = co_await arm_.driver().start_move(std::move(waypoints), speed);
  if (!started) co_return refused(started.error());
  // A stop may have come before there was anything to stop.
  if (stop_requested_) {
    const Result<void> halting = co_await arm_.brake();
    if (!halting) co_return halting;
  }
  const Result<arm::ArmReading> ended = co_await until_ended(false, longest);
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
  Event answered(context_.executor);
  const Job beginning = context_.executor.spawn(start_gripper(opening_mm, begun, answered));
  Time tell_at = context_.executor.now() + tell_period_;
  while (!begun) {
    const Time deadline = context_.executor.now() + poll_period;
    const bool now = co_await answered.wait(deadline);
    if (now) break;
    const Result<arm::ArmReading> reading = co_await arm_.read();
    if (reading) tell_where_due(tell_at);
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
  const Result<arm::ArmReading> ended = co_await until_ended(true, gripping_time);
  if (!ended) co_return fail(ended);
  if (stop_requested_) co_return stopped();
  co_return {};
}

std::unexpected<Failure> ArmControl::stopped() const {
  if (why_stopped_) return std::unexpected(*why_stopped_);
  return fail("stopped", "the motion was stopped before its end", stop_asked_);
}

void ArmControl::stop_at_once(Failure why) {
  if (!running_ && arm_.is_there()) {
    arm_.forget_braking();
    look_now_.wake_all();
  }
  if (!running_ || why_stopped_) return;
  stop_requested_ = true;
  why_stopped_ = std::move(why);
  obeying_ = context_.executor.spawn(obey());
}

// Again and again, while what is to end has not.
Task<void> ArmControl::obey() {
  const std::uint64_t motion = motions_;
  Result<void> obeyed = co_await stop();
  while (!obeyed) {
    arm_.lose(obeyed.error());
    co_await sleep(context_.executor, poll_period);
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
  const Time deadline = context_.executor.now() + arm::stopping_time;
  while (running_ && motions_ == motion) {
    const bool woken = co_await ended_.wait(deadline);
    if (!woken) co_return fail("timeout", "the arm was told to stop and has not", *running_);
  }
  co_return {};
}

}  // namespace pizarra::robot
