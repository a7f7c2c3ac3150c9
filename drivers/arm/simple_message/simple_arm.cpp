#include "drivers/arm/simple_message/simple_arm.hpp"

#include "drivers/arm/held.hpp"

namespace pizarra::arm {

namespace {

line::Dialogue::Fits second_of(line::Dialogue::Fits fits) {
  return [fits = std::move(fits), first = true](const std::string& answer) mutable {
    return fits(answer) && !std::exchange(first, false);
  };
}

}  // namespace

Task<Result<void>> SimpleArm::greet() {
  SimpleMessage ping{.type = simple::ping, .kind = simple::request};
  ping.data = std::string(4 * simple::axes, '\0');
  return order(std::move(ping));
}

Result<std::optional<SimpleJoints>> SimpleArm::angles_in(const SimpleMessage& message) const {
  if (message.type != simple::joint_position) return std::optional<SimpleJoints>();
  const Result<SimplePosition> position = read_position(message.data, wires_.order);
  if (!position) return fail(position);
  return position->joints_rad;
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

Result<void> SimpleArm::able() const {
  const Result<void> sane = sound();
  if (!sane) return sane;
  if (status_.motion_possible == 0) return fail("not-in-control", "the controller says that no motion is possible");
  return {};
}

Task<Result<void>> SimpleArm::take_control() { co_return able(); }

Task<Result<void>> SimpleArm::send_point(Leg leg) {
  SimplePoint point{.sequence = sequence_++, .joints_rad = to_message(leg.to)};
  point.velocity = static_cast<float>(speed_);
  point.duration_s = static_cast<float>(leg.seconds / speed_);
  SimpleMessage message{.type = simple::trajectory_point, .kind = simple::request};
  message.data = write_point(point, wires_.order);
  sent_at_ = executor_.now();
  Result<void> done = co_await order(std::move(message));
  co_return done;
}

Task<Result<void>> SimpleArm::start_move(std::vector<Joints> waypoints, double speed) {
  const Result<void> possible = begin_move(waypoints, speed);
  if (!possible) co_return possible;
  const Held ordering(ordering_);
  const std::vector<Leg> legs = legs_of(model_, joints_, waypoints);
  legs_.assign(legs.begin(), legs.end());
  speed_ = speed;
  sequence_ = 0;
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
  const Result<std::string> answer = co_await ask_to_stop(std::move(request), std::move(is_its_reply));
  const bool aborted = wires_.serial && answer;
  if (aborted) co_return Result<void>();
  co_return obeyed(answer);
}

// Looks whether the leg under way has ended, and sends the next.
Task<void> SimpleArm::go_on() {
  const bool there = stands_at(legs_.front().to);
  const bool begins = !there && may_begin();
  if (begins) co_return;
  if (there && !stopping_ && legs_.size() > 1) {
    legs_.pop_front();
    const Leg next = legs_.front();
    const Result<void> sent = co_await send_point(next);
    if (sent) co_return;
    why_stopped_ = sent.error();
    // Whether it was heard nobody knows: it is not gone to in any case.
    [[maybe_unused]] const Result<void> ended = co_await stop();
  }
  end_move(!there || legs_.size() > 1 || why_stopped_);
}

Task<Result<ArmReading>> SimpleArm::read() {
  if (!told_.known()) co_return told_.unknown();
  if (moving_ && !ordering_ && status_.in_motion == 0) {
    const Held ordering(ordering_);
    co_await go_on();
  }
  co_return reading(status_.drives_powered == 0);
}

}  // namespace pizarra::arm
