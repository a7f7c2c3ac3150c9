#include "drivers/arm/motoman/motoman_arm.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "drivers/arm/held.hpp"
#include "drivers/arm/motoman/refusal_codes.hpp"
#include "drivers/arm/move_check.hpp"

namespace pizarra::arm {

namespace {

constexpr int wanted_opening = 0;  // variables
constexpr int measured_opening = 1;
constexpr int fingers_move = 2;
constexpr double most_opening_mm = 1000;
constexpr double most_mm_s = 1500;

bool refused_with(const Failure& failure, std::int64_t code) {
  return failure.symbol == "refused" && failure.subject == to_datum(code);
}

// Whether a controller that fails so may have done what was asked.
bool perhaps_done(const Failure& failure) { return failure.symbol == "no-answer" || failure.symbol == "bad-reply"; }

}  // namespace

Joints MotomanArm::joints_of(const MotomanPulses& pulses) const {
  Joints joints(model_.axes.size());
  for (std::size_t axis = 0; axis < joints.size(); ++axis) {
    joints[axis] = pulses[axis] * 360.0 / model_.axes[axis].pulses_per_turn;
  }
  return joints;
}

MotomanPulses MotomanArm::pulses_of(const Joints& joints) const {
  MotomanPulses pulses{};
  for (std::size_t axis = 0; axis < joints.size(); ++axis) {
    pulses[axis] = static_cast<std::int32_t>(std::llround(joints[axis] * model_.axes[axis].pulses_per_turn / 360));
  }
  return pulses;
}

Task<Result<std::string>> MotomanArm::identify() {
  for (std::size_t axis = 0; axis < model_.axes.size(); ++axis) {
    if (model_.axes[axis].pulses_per_turn > 0) continue;
    co_return fail("bad-arm", fmt::format("the arm's file does not say the pulses-per-turn of axis {}", axis + 1),
                   to_datum(axis + 1));
  }
  const Time deadline = executor_.now() + opening_time;
  const Result<void> open = co_await link_.open(deadline);
  if (!open) co_return lost(open.error());
  const Result<MotomanPulses> pulses = co_await link_.pulses();
  if (!pulses) co_return lost(pulses.error());
  for (std::size_t axis = model_.axes.size(); axis < motoman_axes; ++axis) {
    if ((*pulses)[axis] == 0) continue;
    co_return fail("unknown-arm", fmt::format("the controller's arm has an axis {}, and a {} has {}", axis + 1,
                                              model_.type, model_.axes.size()));
  }
  co_return model_.type;
}

Task<Result<MotomanArm::Seen>> MotomanArm::look() {
  const Result<MotomanStatus> status = co_await link_.status();
  if (!status) co_return lost(status.error());
  const Result<MotomanPulses> pulses = co_await link_.pulses();
  if (!pulses) co_return lost(pulses.error());
  Seen seen{*status, joints_of(*pulses), executor_.now()};
  seen_ = seen;
  hear_state();
  co_return seen;
}

Task<Result<MotomanArm::Seen>> MotomanArm::look_lately() {
  const bool lately = seen_ && executor_.now() - seen_->at <= fresh;
  if (lately) co_return *seen_;
  co_return co_await look();
}

Task<Result<void>> MotomanArm::take_control() {
  seen_.reset();
  return control_.take();
}

Task<Result<void>> MotomanArm::start_move(std::vector<Joints> waypoints, double speed) {
  const Result<void> sound = check_move(model_, waypoints, speed);
  if (!sound) co_return sound;
  if (moving_ || ordering_) co_return fail("busy", "the arm is moving already");
  const Held ordering(ordering_);
  stopping_ = false;
  const Result<Seen> seen = co_await look_lately();
  if (!seen) co_return fail(seen);
  if (seen->status.running) co_return fail("busy", "the controller moves the arm already");
  const Result<void> ready = co_await control_.ready_to_move(seen->status);
  if (!ready) co_return ready;
  const std::vector<Leg> legs = legs_of(model_, seen->joints, waypoints);
  legs_.assign(legs.begin(), legs.end());
  speed_ = speed;
  stopped_ = false;
  why_stopped_.reset();
  const Result<void> ordered = co_await order(legs_.front(), seen->joints);
  if (!ordered) co_return ordered;
  moving_ = true;
  co_return Result<void>();
}

Task<Result<void>> MotomanArm::order_once(const Leg& leg, const std::optional<Line>& line) {
  if (!line) return link_.move_joints(pulses_of(leg.to), speed_);
  return link_.move_straight(line->target, std::min(line->length_mm / leg.seconds * speed_, most_mm_s));
}

// From where the controller says that its tool is.
Task<Result<MotomanArm::Line>> MotomanArm::line_to(Joints to, Joints from) {
  const Result<MotomanPose> pose = co_await link_.pose();
  if (!pose) co_return lost(pose.error());
  const Eigen::Vector3d way_mm = forward(model_, to).translation() - forward(model_, from).translation();
  Line line{*pose, way_mm.norm()};
  for (std::size_t i = 0; i < 3; ++i) line.target.place_mm[i] += way_mm[static_cast<Eigen::Index>(i)];
  co_return line;
}

// Has the controller begun one leg, exactly once. The arm stands at `from` and nobody else moves it.
Task<Result<void>> MotomanArm::order(Leg leg, Joints from) {
  std::optional<Line> line;
  if (leg.straight) {
    const Result<Line> found = co_await line_to(leg.to, from);
    if (!found) co_return fail(found);
    line = *found;
  }
  for (int i = 0; i < most_orders; ++i) {
    ordered_at_ = executor_.now();
    seen_.reset();
    const Result<void> ordered = co_await order_once(leg, line);
    // An arm that runs although it stood runs for us: it was a copy of the order that was refused.
    const bool begun = ordered || refused_with(ordered.error(), motoman::operating);
    // Somebody wanted it stopped meanwhile, and what was not begun is not begun any more.
    if (begun || stopping_) co_return Result<void>();
    if (!perhaps_done(ordered.error())) co_return lost(ordered.error());
    const Result<Seen> seen = co_await look();
    if (!seen) {
      // Whether it goes there nobody knows: it is held in any case, where the controller hears that.
      [[maybe_unused]] const Result<void> held = co_await stop();
      co_return fail(seen);
    }
    const bool on_its_way = seen->status.running || !are_same_place(seen->joints, from);
    if (on_its_way || stopping_) co_return Result<void>();
  }
  co_return fail("disconnected", "the controller takes no orders");
}

Task<Result<void>> MotomanArm::stop() {
  stopping_ = true;
  seen_.reset();
  const Result<void> held = co_await link_.turn(MotomanSwitch::hold, true);
  if (!held) co_return lost(held.error());
  co_return Result<void>();
}

void MotomanArm::end_move(std::optional<Failure> why_stopped) {
  moving_ = false;
  stopped_ = stopping_ || why_stopped;
  why_stopped_ = std::move(why_stopped);
  legs_.clear();
}

// Looks whether the leg under way has ended, and orders the next.
Task<Result<void>> MotomanArm::go_on(const Seen& seen) {
  if (seen.status.running) co_return Result<void>();
  const bool there = are_same_place(seen.joints, legs_.front().to, legs_.front().straight ? 0.2 : same_place);
  const MotomanStatus& status = seen.status;
  const bool held = !may_move(status) || status.command_hold;
  if (!there && !held && executor_.now() - ordered_at_ < starting_time) co_return Result<void>();
  if (!there || (stopping_ && legs_.size() > 1)) {
    std::optional<Failure> why;
    if (!stopping_) {
      why = co_await control_.why_not(status);
      why->symbol = "stopped";
    }
    end_move(std::move(why));
    co_return Result<void>();
  }
  legs_.pop_front();
  if (legs_.empty()) {
    end_move({});
    co_return Result<void>();
  }
  const Leg next = legs_.front();
  Result<void> ordered = co_await order(next, seen.joints);
  if (!ordered && ordered.error().symbol != "disconnected") {
    ordered.error().symbol = "stopped";
    end_move(ordered.error());
    co_return Result<void>();
  }
  co_return ordered;
}

Task<Result<void>> MotomanArm::start_gripper(double opening_mm) {
  const Result<void> sound = check_opening(opening_mm);
  if (!sound) co_return sound;
  const Result<Seen> seen = co_await look_lately();
  if (!seen) co_return fail(seen);
  const Result<void> ready = co_await control_.ready_to_move(seen->status);
  if (!ready) co_return ready;
  const double opening = std::clamp(opening_mm, 0.0, most_opening_mm);
  const auto um = static_cast<std::int32_t>(std::llround(opening * um_per_mm));
  const Result<void> set = co_await link_.set_variable(wanted_opening, um);
  if (!set) co_return lost(set.error());
  gripping_ = true;
  gripping_since_ = executor_.now();
  co_return Result<void>();
}

Task<Result<void>> MotomanArm::look_at_gripper() {
  const Result<std::int32_t> um = co_await link_.variable(measured_opening);
  if (!um) co_return lost(um.error());
  opening_mm_ = *um / um_per_mm;
  if (!gripping_) co_return Result<void>();
  const Result<std::int32_t> fingers = co_await link_.variable(fingers_move);
  if (!fingers) co_return lost(fingers.error());
  gripping_ = *fingers != 0 || executor_.now() - gripping_since_ < starting_time;
  co_return Result<void>();
}

// Holds an arm that runs in remote mode for nobody, as by a copy of an order that the line has kept until now.
Task<void> MotomanArm::hold_if_nobody_ordered(MotomanStatus status) {
  const bool stray = status.running && status.remote && !status.teaching && !stopping_;
  if (!stray) co_return;
  why_stopped_ = Failure{"stopped", "the arm moved although nobody had ordered it, and was stopped", {}, {}};
  stopped_ = true;
  // Where the controller did not hear it, the next look finds it running still.
  const Result<void> held = co_await stop();
  if (!held) stopping_ = false;
}

Task<Result<ArmReading>> MotomanArm::read() {
  const bool idle = !moving_ && !ordering_;
  const Time ordered_at = ordered_at_;
  const Result<Seen> seen = co_await look();
  if (!seen) co_return fail(seen);
  const bool still_idle = idle && !moving_ && !ordering_ && ordered_at_ == ordered_at;
  if (still_idle) co_await hold_if_nobody_ordered(seen->status);
  if (gripping_ || reads_++ % reads_of_an_opening == 0) {
    const Result<void> looked = co_await look_at_gripper();
    if (!looked) co_return fail(looked);
  }
  co_await control_.look(seen->status);
  // Only one of those who read moves it on.
  if (moving_ && !ordering_) {
    const Held ordering(ordering_);
    const Result<void> gone_on = co_await go_on(*seen);
    if (!gone_on) co_return fail(gone_on);
  }
  ArmReading reading{.joints = seen->joints,
                     .moving = moving_,
                     .stopped = stopped_,
                     .opening_mm = opening_mm_,
                     .gripper_moving = gripping_,
                     .why_stopped = why_stopped_,
                     .trouble = control_.trouble(),
                     .at = seen->at};
  reading.moving = moving_ || seen->status.running;
  co_return reading;
}

}  // namespace pizarra::arm
