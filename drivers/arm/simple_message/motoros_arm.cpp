#include "drivers/arm/simple_message/motoros_arm.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "drivers/arm/held.hpp"

namespace pizarra::arm {

namespace {

Failure refused(const MotorosReply& reply, const char* symbol) {
  return {symbol,
          fmt::format("the controller refused: {}", meaning_of(reply)),
          to_datum(reply.subcode != 0 ? reply.subcode : reply.result),
          {}};
}

}  // namespace

Task<Result<std::string>> MotorosArm::identify() {
  sending_ = Job();
  return MessageArm::identify();
}

Task<Result<void>> MotorosArm::greet() {
  const Result<MotorosReply> there = co_await command(motoros::check_ready);
  if (!there) co_return fail(there);
  co_return Result<void>();
}

Result<std::optional<SimpleJoints>> MotorosArm::angles_in(const SimpleMessage& message) const {
  if (message.type != motoros::feedback) return std::optional<SimpleJoints>();
  const Result<MotorosFeedback> feedback = read_feedback(message.data, wires_.order);
  if (!feedback) return fail(feedback);
  const bool of_the_arm = feedback->group == 0 && (feedback->has & motoros::has_position) != 0;
  if (!of_the_arm) return std::optional<SimpleJoints>();
  return feedback->joints_rad;
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
  const Result<void> sane = sound();
  if (!sane) return sane;
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

Task<Result<void>> MotorosArm::release_control() {
  const Result<MotorosReply> ended = co_await command(motoros::stop_trajectories);
  if (!ended) co_return fail(ended);
  if (ended->result != motoros::success) co_return fail(refused(*ended, "refused"));
  co_return Result<void>();
}

// A controller that is busy is asked again.
Task<Result<void>> MotorosArm::send_point(std::size_t index) {
  const TimedPoint& from = points_[index];
  MotorosPoint point{.sequence = static_cast<std::int32_t>(index), .time_s = static_cast<float>(from.time_s)};
  point.joints_rad = to_message(from.joints);
  point.speeds_rad_s = to_message(from.speeds);
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
  const Result<void> begun = begin_move(waypoints, speed);
  if (!begun) co_return begun;
  const Held ordering(ordering_);
  points_ = timed_points(model_, joints_, waypoints, speed);
  sent_ = 0;
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
  line::Dialogue::Fits fits = reply_to(motoros::stop_motion, commands_);
  const Result<std::string> answer = co_await ask_to_stop(std::move(request), std::move(fits));
  const Result<MotorosReply> reply = reply_in(answer, wires_.order);
  if (!reply) co_return fail(reply);
  if (reply->result != motoros::success) co_return fail(refused(*reply, "refused"));
  co_return Result<void>();
}

bool MotorosArm::there() const {
  return !points_.empty() && sent_ == points_.size() && stands_at(points_.back().joints);
}

Task<Result<ArmReading>> MotorosArm::read() {
  if (!told_.known()) co_return told_.unknown();
  const bool all_sent = sent_ == points_.size() || stopping_ || !able();
  const bool begins = !there() && may_begin();
  if (moving_ && status_.in_motion == 0 && all_sent && !begins) end_move(!there());
  co_return reading(true);
}

}  // namespace pizarra::arm
