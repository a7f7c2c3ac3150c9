#include "drivers/arm/simple_message/motoros_arm.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "drivers/arm/held.hpp"
#include "drivers/arm/move_check.hpp"
#include "drivers/arm/route.hpp"

namespace pizarra::arm {

namespace {

line::FrameReader frames_of(line::ByteOrder order) {
  return order == line::ByteOrder::little ? frame_of_tcp_little : frame_of_tcp_big;
}

constexpr double every_angle = 1;  // its angles count as the axes' do

Failure refused(const MotorosReply& reply, const char* symbol) {
  return {symbol,
          fmt::format("the controller refused: {}", meaning_of(reply)),
          to_datum(reply.subcode != 0 ? reply.subcode : reply.result),
          {}};
}

}  // namespace

MotorosArm::MotorosArm(Executor& executor, MotorosWires wires, ArmModel model)
    : executor_(executor),
      wires_(wires),
      model_(std::move(model)),
      motion_(executor, wires.motion, frames_of(wires.order), "the controller"),
      states_(executor, wires.state, frames_of(wires.order), "the controller"),
      told_(states_, fresh),
      joints_(model_.ready) {}

Task<Result<std::string>> MotorosArm::identify() {
  told_.forget();
  sending_ = Job();
  const Time deadline = executor_.now() + opening_time;
  // Each of them, whatever becomes of the other: a stop needs the first alone.
  const Result<void> heard = co_await motion_.open(deadline);
  const Result<void> hears_us = co_await states_.open(deadline);
  if (!heard) co_return fail(heard);
  if (!hears_us) co_return fail(hears_us);
  const Result<MotorosReply> there = co_await command(motoros::check_ready);
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

Result<bool> MotorosArm::hear(const std::string& octets) {
  const Result<SimpleMessage> message = read_simple(octets, wires_.order);
  if (!message) return fail(message);
  if (message->type == simple::status) {
    const Result<SimpleStatus> status = read_status(message->data, wires_.order);
    if (!status) return fail(status);
    status_ = *status;
  }
  if (message->type != motoros::feedback) return false;
  const Result<MotorosFeedback> feedback = read_feedback(message->data, wires_.order);
  if (!feedback) return fail(feedback);
  const bool of_the_arm = feedback->group == 0 && (feedback->has & motoros::has_position) != 0;
  if (!of_the_arm) return false;
  std::size_t next = 0;
  for (std::size_t axis = 0; axis < joints_.size(); ++axis) {
    if (!told(axis)) continue;
    joints_[axis] = axis_of_joint(model_.axes[axis].role, feedback->joints_rad[next++], every_angle);
  }
  const auto first = feedback->joints_rad.begin();
  const auto further = std::find_if(first + static_cast<std::ptrdiff_t>(next), feedback->joints_rad.end(),
                                    [](float joint) { return joint != 0; });
  further_axis_.reset();
  if (further != feedback->joints_rad.end()) further_axis_ = further - first;
  hear_state();
  return true;
}

std::string MotorosArm::framed(const SimpleMessage& message) const {
  return tcp_frame(write_simple(message, wires_.order), wires_.order);
}

line::Dialogue::Fits MotorosArm::reply_to(std::int32_t command, std::int32_t sequence) const {
  return [command, sequence, order = wires_.order](const std::string& octets) {
    const Result<SimpleMessage> message = read_simple(octets, order);
    if (!message || message->type != motoros::motion_reply) return false;
    const Result<MotorosReply> reply = read_reply(message->data, order);
    return reply && reply->command == command && reply->sequence == sequence;
  };
}

// A command that bears the next number.
std::string MotorosArm::control_message(std::int32_t what) {
  SimpleMessage message{.type = motoros::motion_control, .kind = simple::request};
  message.data = write_control({.sequence = ++commands_, .command = what}, wires_.order);
  return framed(message);
}

namespace {

Result<MotorosReply> reply_in(const Result<std::string>& answer, line::ByteOrder order) {
  if (!answer) return fail(answer);
  const Result<SimpleMessage> message = read_simple(*answer, order);
  return read_reply(message->data, order);
}

}  // namespace

Task<Result<MotorosReply>> MotorosArm::command(std::int32_t what) {
  std::string request = control_message(what);
  line::Dialogue::Fits fits = reply_to(what, commands_);
  const Result<std::string> answer = co_await motion_.ask(std::move(request), std::move(fits));
  co_return reply_in(answer, wires_.order);
}

Result<void> MotorosArm::able() const {
  if (!told_.known()) return told_.unknown();
  const Result<void> sound = check_status(status_);
  if (!sound) return sound;
  if (status_.motion_possible != 0) return {};
  return fail("not-in-control", "the controller takes no trajectories: (get-control) begins that mode");
}

Task<Result<void>> MotorosArm::take_control() {
  if (!told_.known()) co_return told_.unknown();
  const Result<MotorosReply> begun = co_await command(motoros::start_trajectories);
  const bool refuses = begun && begun->result != motoros::success;
  if (refuses) co_return fail(refused(*begun, "not-in-control"));
  // It answers once its servos are on and its job runs, which may take longer than an answer: its state says so, too.
  std::function<bool()> ready = [this] { return able().has_value(); };
  const bool on = co_await told_.until(std::move(ready), power_time);
  if (!on) co_return able();
  co_return Result<void>();
}

// A controller that is busy is asked again.
Task<Result<void>> MotorosArm::send_point(std::size_t index) {
  const TimedPoint& from = points_[index];
  MotorosPoint point{.sequence = static_cast<std::int32_t>(index), .time_s = static_cast<float>(from.time_s)};
  std::size_t next = 0;
  for (std::size_t axis = 0; axis < from.joints.size(); ++axis) {
    if (!told(axis)) continue;
    const Role role = model_.axes[axis].role;
    point.joints_rad[next] = joint_of_axis(role, from.joints[axis], every_angle);
    point.speeds_rad_s[next++] = joint_of_axis(role, from.speeds[axis], every_angle);
  }
  SimpleMessage message{.type = motoros::trajectory_point, .kind = simple::request};
  message.data = write_motoros_point(point, wires_.order);
  const Time busy_until = executor_.now() + busy_time;
  while (true) {
    std::string request = framed(message);
    line::Dialogue::Fits fits = reply_to(motoros::trajectory_point, point.sequence);
    const Result<std::string> answer = co_await motion_.ask(std::move(request), std::move(fits));
    const Result<MotorosReply> reply = reply_in(answer, wires_.order);
    if (!reply) co_return fail(reply);
    if (reply->result == motoros::success) break;
    const bool later = reply->result == motoros::busy && executor_.now() < busy_until;
    if (!later) co_return fail(refused(*reply, reply->result == motoros::not_ready ? "not-in-control" : "refused"));
    co_await sleep(executor_, ask_again);
  }
  sent_ = index + 1;
  sent_at_ = executor_.now();
  co_return Result<void>();
}

Task<Result<void>> MotorosArm::start_move(std::vector<Joints> waypoints, double speed) {
  const Result<void> sound = check_move(model_, waypoints, speed);
  if (!sound) co_return sound;
  if (moving_ || ordering_) co_return fail("busy", "the arm is moving already");
  const Result<void> ready = able();
  if (!ready) co_return ready;
  constexpr double slack = 0.5;
  for (std::size_t axis = 0; axis < joints_.size(); ++axis) {
    if (told(axis) || std::abs(waypoints.back()[axis] - joints_[axis]) < slack) continue;
    co_return fail("bad-request", "the track is another control group, and is not moved", to_datum(axis + 1));
  }
  const Held ordering(ordering_);
  points_ = timed_points(model_, joints_, waypoints, speed);
  sent_ = 0;
  stopping_ = false;
  stopped_ = false;
  why_stopped_.reset();
  const std::size_t first = std::min<std::size_t>(points_.size(), 2);  // the first is where it stands
  for (std::size_t i = 0; i < first; ++i) {
    const Result<void> taken = co_await send_point(i);
    if (taken) continue;
    // Whether it was heard nobody knows: it is not gone to in any case.
    [[maybe_unused]] const Result<void> ended = co_await stop();
    co_return taken;
  }
  moving_ = true;
  sending_ = executor_.spawn(send_the_rest());
  co_return Result<void>();
}

Task<void> MotorosArm::send_the_rest() {
  while (sent_ < points_.size() && !stopping_) {
    const Result<void> taken = co_await send_point(sent_);
    if (taken || stopping_) continue;
    why_stopped_ = taken.error();
    why_stopped_->symbol = "stopped";
    [[maybe_unused]] const Result<void> ended = co_await end_trajectory();
  }
}

// No point may follow the stop, not even one that is asked again because the controller was busy.
Task<Result<void>> MotorosArm::stop() {
  sending_ = Job();
  return end_trajectory();
}

Task<Result<void>> MotorosArm::end_trajectory() {
  stopping_ = true;
  std::string request = control_message(motoros::stop_motion);
  const std::int32_t sequence = commands_;
  line::Dialogue::Fits fits = reply_to(motoros::stop_motion, sequence);
  Result<std::string> answer = co_await motion_.ask_at_once(request, fits);
  const bool lost = !motion_.say({});
  if (lost) {
    const Time deadline = executor_.now() + stopping_time;
    const Result<void> open = co_await motion_.open(deadline);
    if (!open) co_return fail(open);
    answer = co_await motion_.ask_at_once(std::move(request), std::move(fits));
  }
  const Result<MotorosReply> reply = reply_in(answer, wires_.order);
  if (!reply) co_return fail(reply);
  if (reply->result != motoros::success) co_return fail(refused(*reply, "refused"));
  co_return Result<void>();
}

Task<Result<void>> MotorosArm::start_gripper(double opening_mm) {
  const Result<void> sound = check_opening(opening_mm);
  if (!sound) co_return sound;
  co_return fail("refused", "the protocol of this arm's controller has no gripper", to_datum(opening_mm));
}

bool MotorosArm::there() const {
  constexpr double rounded = 0.05;  // a float of radians, and what the controller makes of it
  return !points_.empty() && sent_ == points_.size() && are_same_place(joints_, points_.back().joints, rounded);
}

Task<Result<ArmReading>> MotorosArm::read() {
  if (!told_.known()) co_return told_.unknown();
  const Result<void> sound = able();
  const bool all_sent = sent_ == points_.size() || stopping_ || !sound;
  const bool begins = !there() && !stopping_ && sound && executor_.now() - sent_at_ <= starting_time;
  if (moving_ && status_.in_motion == 0 && all_sent && !begins) {
    moving_ = false;
    stopped_ = !there();
    if (stopped_ && !stopping_)
      why_stopped_ = sound ? Failure{"stopped", "the controller has ended the motion", {}, {}} : sound.error();
    if (why_stopped_) why_stopped_->symbol = "stopped";
  }
  ArmReading reading{.joints = joints_,
                     .moving = moving_ || status_.in_motion == 1,
                     .stopped = stopped_,
                     .opening_mm = 0,
                     .gripper_moving = false,
                     .why_stopped = why_stopped_,
                     .at = told_.told_at()};
  if (!sound) {
    using Kind = ArmTrouble::Kind;
    const bool stopped = status_.emergency_stopped == 1 || status_.mode == 1;
    reading.trouble = ArmTrouble{status_.in_error == 1 ? Kind::fault
                                 : stopped             ? Kind::stopped
                                                       : Kind::off,
                                 sound.error()};
  }
  co_return reading;
}

}  // namespace pizarra::arm
