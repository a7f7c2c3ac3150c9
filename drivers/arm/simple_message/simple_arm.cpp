#include "drivers/arm/simple_message/simple_arm.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "drivers/arm/held.hpp"
#include "drivers/arm/move_check.hpp"

namespace pizarra::arm {

namespace {

line::FrameReader frames_of(const SimpleWires& wires) {
  if (wires.serial) return frame_of_serial;
  return wires.order == line::ByteOrder::little ? frame_of_tcp_little : frame_of_tcp_big;
}

line::Dialogue::Fits second_of(line::Dialogue::Fits fits) {
  return [fits = std::move(fits), first = true](const std::string& answer) mutable {
    return fits(answer) && !std::exchange(first, false);
  };
}

}  // namespace

SimpleArm::SimpleArm(Executor& executor, SimpleWires wires, ArmModel model)
    : executor_(executor),
      wires_(wires),
      model_(std::move(model)),
      motion_(executor, wires.motion, frames_of(wires), "the controller"),
      states_(executor, wires.state, frames_of(wires), "the controller"),
      told_(states_, fresh),
      joints_(model_.ready) {
  if (wires_.serial) wires_.order = line::ByteOrder::little;
}

Task<Result<std::string>> SimpleArm::identify() {
  told_.forget();
  const Time deadline = executor_.now() + opening_time;
  // Each of them, whatever becomes of the other: a stop needs the first alone.
  const Result<void> heard = co_await motion_.open(deadline);
  const Result<void> hears_us = co_await states_.open(deadline);
  if (!heard) co_return fail(heard);
  if (!hears_us) co_return fail(hears_us);
  SimpleMessage ping{.type = simple::ping, .kind = simple::request};
  ping.data = std::string(4 * simple::axes, '\0');
  const Result<void> there = co_await order(std::move(ping));
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

Result<bool> SimpleArm::hear(const std::string& octets) {
  const Result<SimpleMessage> message = read_simple(octets, wires_.order);
  if (!message) return fail(message);
  if (message->type == simple::status) {
    const Result<SimpleStatus> status = read_status(message->data, wires_.order);
    if (!status) return fail(status);
    status_ = *status;
  }
  if (message->type != simple::joint_position) return false;
  const Result<SimplePosition> position = read_position(message->data, wires_.order);
  if (!position) return fail(position);
  std::size_t next = 0;
  for (std::size_t axis = 0; axis < joints_.size(); ++axis) {
    if (told(axis)) joints_[axis] = axis_of_joint(model_.axes[axis].role, position->joints_rad[next++], wires_.sign);
  }
  const auto further = std::find_if(position->joints_rad.begin() + static_cast<std::ptrdiff_t>(next),
                                    position->joints_rad.end(), [](float joint) { return joint != 0; });
  further_axis_.reset();
  if (further != position->joints_rad.end()) further_axis_ = further - position->joints_rad.begin();
  hear_state();
  return true;
}

std::string SimpleArm::framed(const SimpleMessage& message) const {
  const std::string octets = write_simple(message, wires_.order);
  return wires_.serial ? serial_frame(octets) : tcp_frame(octets, wires_.order);
}

line::Dialogue::Fits SimpleArm::reply_to(const SimpleMessage& message) const {
  return [type = message.type, order = wires_.order](const std::string& answer) {
    const Result<SimpleMessage> reply = read_simple(answer, order);
    return reply && reply->type == type && reply->kind == simple::reply;
  };
}

// Sends a message and waits for its reply.
Task<Result<void>> SimpleArm::order(SimpleMessage message) {
  std::string request = framed(message);
  line::Dialogue::Fits is_its_reply = reply_to(message);
  const Result<std::string> answer = co_await motion_.ask(std::move(request), std::move(is_its_reply));
  co_return obeyed(answer);
}

Result<void> SimpleArm::obeyed(const Result<std::string>& answer) const {
  if (!answer) return fail(answer);
  const Result<SimpleMessage> reply = read_simple(*answer, wires_.order);
  if (reply->code == simple::success) return {};
  return fail("refused", "the controller refused the motion", to_datum(reply->code));
}

Result<void> SimpleArm::possible() const {
  if (!told_.known()) return told_.unknown();
  const Result<void> sound = check_status(status_);
  if (!sound) return sound;
  if (status_.motion_possible == 0) return fail("not-in-control", "the controller says that no motion is possible");
  return {};
}

Task<Result<void>> SimpleArm::take_control() { co_return possible(); }

Task<Result<void>> SimpleArm::send_point(Leg leg) {
  SimplePoint point{.sequence = sequence_++};
  std::size_t next = 0;
  for (std::size_t axis = 0; axis < leg.to.size(); ++axis) {
    if (told(axis)) point.joints_rad[next++] = joint_of_axis(model_.axes[axis].role, leg.to[axis], wires_.sign);
  }
  point.velocity = static_cast<float>(speed_);
  point.duration_s = static_cast<float>(leg.seconds / speed_);
  SimpleMessage message{.type = simple::trajectory_point, .kind = simple::request};
  message.data = write_point(point, wires_.order);
  sent_at_ = executor_.now();
  Result<void> done = co_await order(std::move(message));
  co_return done;
}

Task<Result<void>> SimpleArm::start_move(std::vector<Joints> waypoints, double speed) {
  const Result<void> sound = check_move(model_, waypoints, speed);
  if (!sound) co_return sound;
  if (moving_ || ordering_) co_return fail("busy", "the arm is moving already");
  const Result<void> ready = possible();
  if (!ready) co_return ready;
  for (std::size_t axis = 0; axis < joints_.size(); ++axis) {
    if (told(axis) || std::abs(waypoints.back()[axis] - joints_[axis]) < 0.5) continue;
    co_return fail("bad-request", "the controller does not have the track", to_datum(axis + 1));
  }
  const Held ordering(ordering_);
  const std::vector<Leg> legs = legs_of(model_, joints_, waypoints);
  legs_.assign(legs.begin(), legs.end());
  speed_ = speed;
  sequence_ = 0;
  stopping_ = false;
  stopped_ = false;
  why_stopped_.reset();
  const Leg first = legs_.front();
  const Result<void> begun = co_await send_point(first);
  if (!begun) {
    // Whether it was heard nobody knows: it is not gone to in any case.
    [[maybe_unused]] const Result<void> ended = co_await stop();
    co_return begun;
  }
  moving_ = true;
  co_return Result<void>();
}

Task<Result<void>> SimpleArm::stop() {
  stopping_ = true;
  SimpleMessage message{.type = simple::trajectory_point, .kind = simple::request};
  message.data = write_point({.sequence = simple::stop_trajectory}, wires_.order);
  std::string request = framed(message);
  line::Dialogue::Fits is_its_reply = reply_to(message);
  if (wires_.serial) {
    message.data = write_point({.sequence = simple::nobodys_number}, wires_.order);
    request += framed(message);
    is_its_reply = second_of(std::move(is_its_reply));
  }
  Result<std::string> answer = co_await motion_.ask_at_once(request, is_its_reply);
  const bool lost = !motion_.say({});
  if (lost) {
    const Time deadline = executor_.now() + stopping_time;
    const Result<void> open = co_await motion_.open(deadline);
    if (!open) co_return fail(open);
    answer = co_await motion_.ask_at_once(request, is_its_reply);
  }
  const bool aborted = wires_.serial && answer;
  if (aborted) co_return Result<void>();
  co_return obeyed(answer);
}

Task<Result<void>> SimpleArm::start_gripper(double opening_mm) {
  const Result<void> sound = check_opening(opening_mm);
  if (!sound) co_return sound;
  co_return fail("refused", "the protocol of this arm's controller has no gripper", to_datum(opening_mm));
}

// Looks whether the leg under way has ended, and sends the next.
Task<void> SimpleArm::go_on() {
  constexpr double rounded = 0.05;  // a float of radians, and what the controller makes of it
  const bool there = are_same_place(joints_, legs_.front().to, rounded);
  const Result<void> able = possible();
  const bool begins = !there && able && !stopping_ && executor_.now() - sent_at_ <= starting_time;
  if (begins) co_return;
  std::optional<Failure> why;
  if (there && !stopping_ && legs_.size() > 1) {
    legs_.pop_front();
    const Leg next = legs_.front();
    const Result<void> sent = co_await send_point(next);
    if (sent) co_return;
    why = sent.error();
    // Whether it was heard nobody knows: it is not gone to in any case.
    [[maybe_unused]] const Result<void> ended = co_await stop();
  } else if (!there && !stopping_) {
    why = Failure{"stopped", "the controller has ended the motion", {}, {}};
    if (!able) why = able.error();
  }
  moving_ = false;
  stopped_ = !there || legs_.size() > 1 || why;
  why_stopped_ = std::move(why);
  if (why_stopped_) why_stopped_->symbol = "stopped";
}

Task<Result<ArmReading>> SimpleArm::read() {
  if (!told_.known()) co_return told_.unknown();
  if (moving_ && !ordering_ && status_.in_motion == 0) {
    const Held ordering(ordering_);
    co_await go_on();
  }
  ArmReading reading{.joints = joints_,
                     .moving = moving_ || status_.in_motion == 1,
                     .stopped = stopped_,
                     .opening_mm = 0,
                     .gripper_moving = false,
                     .why_stopped = why_stopped_,
                     .at = told_.told_at()};
  const Result<void> able = possible();
  if (!able) {
    using Kind = ArmTrouble::Kind;
    const bool stopped = status_.emergency_stopped == 1 || status_.mode == 1 || status_.drives_powered != 0;
    const Kind kind = status_.in_error == 1 ? Kind::fault : stopped ? Kind::stopped : Kind::off;
    reading.trouble = ArmTrouble{kind, able.error()};
  }
  co_return reading;
}

}  // namespace pizarra::arm
