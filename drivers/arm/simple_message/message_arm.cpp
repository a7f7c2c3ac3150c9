#include "drivers/arm/simple_message/message_arm.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "drivers/arm/move_check.hpp"
#include "drivers/arm/route.hpp"

namespace pizarra::arm {

namespace {

line::FrameReader frames_of(const SimpleWires& wires) {
  if (wires.serial) return frame_of_serial;
  return wires.order == line::ByteOrder::little ? frame_of_tcp_little : frame_of_tcp_big;
}

}  // namespace

MessageArm::MessageArm(Executor& executor, SimpleWires wires, ArmModel model)
    : executor_(executor),
      wires_(wires),
      model_(std::move(model)),
      motion_(executor, wires.motion, frames_of(wires), "the controller"),
      states_(executor, wires.state, frames_of(wires), "the controller"),
      told_(states_, fresh),
      joints_(model_.ready) {
  if (wires_.serial) wires_.order = line::ByteOrder::little;
}

Task<Result<std::string>> MessageArm::identify() {
  told_.forget();
  const Time deadline = executor_.now() + opening_time;
  // Each of them, whatever becomes of the other: a stop needs the first alone.
  const Result<void> hears_us = co_await motion_.open(deadline);
  const Result<void> heard = co_await states_.open(deadline);
  if (!hears_us) co_return fail(hears_us);
  if (!heard) co_return fail(heard);
  const Result<void> there = co_await greet();
  if (!there) co_return fail(there);
  line::ToldState::Hear hears = [this](const std::string& octets) { return hear(octets); };
  const Result<void> known = co_await told_.listen(std::move(hears), opening_time);
  if (!known) co_return fail(known);
  if (further_axis_) {
    co_return fail("unknown-arm",
                   fmt::format("the controller's arm has an axis {}, and of a {} it would tell {}", *further_axis_ + 1,
                               model_.type, *further_axis_),
                   to_datum(*further_axis_ + 1));
  }
  co_return model_.type;
}

Result<bool> MessageArm::hear(const std::string& octets) {
  const Result<SimpleMessage> message = read_simple(octets, wires_.order);
  if (!message) return fail(message);
  if (message->type == simple::status) {
    const Result<SimpleStatus> status = read_status(message->data, wires_.order);
    if (!status) return fail(status);
    status_ = *status;
  }
  const Result<std::optional<SimpleJoints>> angles = angles_in(*message);
  if (!angles) return fail(angles);
  if (!*angles) return false;
  take(**angles);
  hear_state();
  return true;
}

void MessageArm::take(const SimpleJoints& angles) {
  std::size_t next = 0;
  for (std::size_t axis = 0; axis < joints_.size(); ++axis) {
    if (told(axis)) joints_[axis] = axis_of_joint(model_.axes[axis].role, angles[next++], wires_.sign);
  }
  const auto further = std::find_if(angles.begin() + static_cast<std::ptrdiff_t>(next), angles.end(),
                                    [](float angle) { return angle != 0; });
  further_axis_.reset();
  if (further != angles.end()) further_axis_ = further - angles.begin();
}

SimpleJoints MessageArm::to_message(const Joints& axes) const {
  SimpleJoints out{};
  std::size_t next = 0;
  for (std::size_t axis = 0; axis < axes.size(); ++axis) {
    if (told(axis)) out[next++] = joint_of_axis(model_.axes[axis].role, axes[axis], wires_.sign);
  }
  return out;
}

std::string MessageArm::framed(const SimpleMessage& message) const {
  const std::string octets = write_simple(message, wires_.order);
  return wires_.serial ? serial_frame(octets) : tcp_frame(octets, wires_.order);
}

bool MessageArm::stands_at(const Joints& place) const {
  constexpr double rounded = 0.05;  // a float of radians, and what the controller makes of it
  return are_same_place(joints_, place, rounded);
}

Result<void> MessageArm::sound() const {
  if (!told_.known()) return told_.unknown();
  return check_status(status_);
}

Result<void> MessageArm::begin_move(const std::vector<Joints>& waypoints, double speed) {
  const Result<void> possible = check_move(model_, waypoints, speed);
  if (!possible) return possible;
  if (moving_ || ordering_) return fail("busy", "the arm is moving already");
  const Result<void> ready = able();
  if (!ready) return ready;
  constexpr double slack = 0.5;
  for (std::size_t axis = 0; axis < joints_.size(); ++axis) {
    if (told(axis) || std::abs(waypoints.back()[axis] - joints_[axis]) < slack) continue;
    return fail("bad-request", "the controller does not move the track with the arm", to_datum(axis + 1));
  }
  stopping_ = false;
  stopped_ = false;
  why_stopped_.reset();
  return {};
}

void MessageArm::end_move(bool too_early) {
  moving_ = false;
  stopped_ = too_early;
  if (stopped_ && !stopping_) {
    const Result<void> now = able();
    why_stopped_ = now ? Failure{"stopped", "the controller has ended the motion", {}, {}} : now.error();
  }
  if (why_stopped_) why_stopped_->symbol = "stopped";
}

Task<Result<std::string>> MessageArm::ask_to_stop(std::string request, line::Dialogue::Fits fits) {
  Result<std::string> answer = co_await motion_.ask_at_once(request, fits);
  const bool lost = !motion_.say({});
  if (!lost) co_return answer;
  const Time deadline = executor_.now() + reopening_time;
  const Result<void> open = co_await motion_.open(deadline);
  if (!open) co_return fail(open);
  answer = co_await motion_.ask_at_once(std::move(request), std::move(fits));
  co_return answer;
}

Task<Result<void>> MessageArm::start_gripper(double opening_mm) {
  const Result<void> possible = check_opening(opening_mm);
  if (!possible) co_return possible;
  co_return fail("refused", "the protocol of this arm's controller has no gripper", to_datum(opening_mm));
}

ArmReading MessageArm::reading(bool off) const {
  ArmReading reading{.joints = joints_,
                     .moving = moving_ || status_.in_motion == 1,
                     .stopped = stopped_,
                     .opening_mm = 0,
                     .gripper_moving = false,
                     .why_stopped = why_stopped_,
                     .at = told_.told_at()};
  const Result<void> now = able();
  if (now) return reading;
  using Kind = ArmTrouble::Kind;
  const bool stopped = status_.emergency_stopped == 1 || status_.mode == 1 || !off;
  reading.trouble = ArmTrouble{status_.in_error == 1 ? Kind::fault : stopped ? Kind::stopped : Kind::off, now.error()};
  return reading;
}

}  // namespace pizarra::arm
