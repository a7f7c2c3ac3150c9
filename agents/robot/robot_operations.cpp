// What is asked of the robot agent: which operation it is, whether its caller may ask for it, and those that move
// something: motions, held jogs, the gripper.

#include <algorithm>

#include "agents/robot/carry.hpp"
#include "agents/robot/jog.hpp"
#include "agents/robot/robot_state.hpp"
#include "agents/runtime/hold_deadlines.hpp"
#include "lisp/writer.hpp"

namespace pizarra::robot {

namespace {

constexpr double max_opening_mm = 100;
// Fingers that stand so much wider than they were sent have something between them.
constexpr double widened_mm = 3;

// Open to all; whatever else is asked for changes something, and is its commander's to ask for.
bool only_monitors(const Datum& operation) {
  return operation.is_form("get-status") || operation.is_form("monitor") || operation.is_form("finish");
}

}  // namespace

Task<Result<Datum>> RobotAgent::State::handle(Fact request) {
  Datum operation = request.datum[3];
  if (only_monitors(operation)) return answer_monitor(std::move(operation));
  if (earlier && earlier->request == request.datum[1]) return answer_with(earlier->answer);
  const Result<void> allowed = reflex.allows(request.teller);
  if (!allowed) return answer_with(fail(allowed));
  if (is_motion(operation)) return move(std::move(request));
  if (operation.is_form("jog")) return jog(std::move(request));
  if (operation.is_form("gripper")) return gripper(std::move(request));
  if (operation.is_form("speed")) return speed(std::move(operation));
  if (operation.is_form("learn")) return learn(std::move(operation));
  if (operation.is_form("release-control")) return release_control(std::move(request));
  return get_control(std::move(operation));
}

Task<Result<Datum>> RobotAgent::State::answer_with(Result<Datum> known) { co_return known; }

bool RobotAgent::State::holds_something(const arm::ArmReading& reading) const {
  if (reading.gripped) return *reading.gripped;
  return fingers_sent_mm && reading.opening_mm > *fingers_sent_mm + widened_mm;
}

Task<Result<Datum>> RobotAgent::State::move(Fact request) {
  const Datum operation = request.datum[3];
  const Result<InHand> in_hand = control.take_in_hand(request.datum);
  if (!in_hand) co_return fail(in_hand);
  const Result<arm::ArmReading> reading = co_await connection.read();
  if (!reading) co_return fail(reading);
  const arm::Joints at = reading->joints;
  Result<Motion> motion = plan_motion(model, operation, at, variables);
  if (!motion) co_return fail(motion);
  const Result<void> inside = check_room(model, room, at, motion->waypoints);
  if (!inside) co_return fail(inside);
  if (motion->waypoints.empty()) {
    facts.set_arm("idle", write(operation));
    const Result<void> told = co_await facts.tell_surely();
    if (!told) co_return fail(told);
    co_return answer(!motion->at_limit);
  }
  double speed_part = speed_percent / 100;
  if (holds_something(*reading)) speed_part = std::min(speed_part, carry_speed(model, at, motion->waypoints));
  Task<Result<void>> following = control.follow(at, std::move(motion->waypoints), speed_part);
  co_return co_await carry_out(std::move(request), std::move(following));
}

Task<Result<Datum>> RobotAgent::State::jog(Fact request) {
  const Datum operation = request.datum[3];
  const double least_ms = std::chrono::duration<double, std::milli>(runtime::least_hold_deadline).count();
  const double longest_ms = std::chrono::duration<double, std::milli>(runtime::longest_hold_deadline).count();
  const Result<double> given_ms = amount_in(operation[2], least_ms, longest_ms, "ms");
  if (!given_ms) co_return fail(given_ms);
  const auto deadline = std::chrono::duration_cast<Duration>(std::chrono::duration<double, std::milli>(*given_ms));
  const Result<InHand> in_hand = control.take_in_hand(request.datum);
  if (!in_hand) co_return fail(in_hand);
  const Result<void> held = co_await holds.await(request.teller, deadline);
  if (!held) co_return fail(held);
  const Result<arm::ArmReading> reading = co_await connection.read();
  if (!reading) co_return fail(reading);
  const arm::Joints at = reading->joints;
  Result<Motion> motion = plan_jog(model, room, operation[1].text(), at);
  if (!motion) co_return fail(motion);
  if (motion->at_limit) co_return answer(false);
  Task<Result<void>> following = follow_while_held(request.teller, deadline, at, std::move(motion->waypoints));
  co_return co_await carry_out(std::move(request), std::move(following));
}

// To let go is how a jog ends.
Task<Result<void>> RobotAgent::State::follow_while_held(std::string client, Duration deadline, arm::Joints from,
                                                        std::vector<arm::Joints> waypoints) {
  const Result<void> held = co_await holds.await(client, deadline);
  if (!held) co_return held;
  const double speed_part = std::min(speed_percent / 100, jog_speed(model, from, waypoints, deadline));
  const Holds::Watching watching(holds, client, deadline);
  Result<void> moved = co_await control.follow(from, std::move(waypoints), speed_part);
  const bool released = !moved && moved.error().symbol == Holds::released;
  if (released) co_return Result<void>();
  co_return moved;
}

Task<Result<Datum>> RobotAgent::State::gripper(Fact request) {
  const Datum operation = request.datum[3];
  const Result<double> opening_mm = clamped_amount(operation[1], max_opening_mm, "mm");
  if (!opening_mm) co_return fail(opening_mm);
  const Result<InHand> in_hand = control.take_in_hand(request.datum);
  if (!in_hand) co_return fail(in_hand);
  fingers_sent_mm = *opening_mm;
  Task<Result<void>> gripping = control.grip(*opening_mm);
  co_return co_await carry_out(std::move(request), std::move(gripping));
}

// The board has it before anything moves, a round trip, and how it ended before it is answered: whenever this agent
// dies, its successor knows what to answer, and moves nothing twice.
Task<Result<Datum>> RobotAgent::State::carry_out(Fact request, Task<Result<void>> motion) {
  const Datum& id = request.datum[1];
  facts.set_arm("moving", write(request.datum[3]));
  Transaction begin;
  begin.tell(motion_fact(id, Datum()));
  const Result<void> begun = co_await facts.tell_surely(std::move(begin));
  if (!begun) {
    facts.set_arm("idle");
    co_return fail(begun);
  }
  const Reflex::Watching watching(reflex, request.teller, service.presence());
  // Anything may have been said meanwhile.
  Result<void> moved = reflex.allows(request.teller);
  if (moved) moved = co_await motion;
  if (moved) facts.set_arm("idle");
  if (!moved && connection.is_there()) {
    const bool stopped = control.was_stopped() || moved.error().symbol == "stopped";
    facts.set_arm(moved.error().symbol == "fault" ? "fault" : stopped ? "stopped" : "idle");
  }
  Transaction end;
  end.tell(motion_fact(id, moved ? list("ok"_sym, "true"_sym) : failure_to_datum(moved.error())));
  const Result<void> told = co_await facts.tell_surely(std::move(end));
  if (!moved) co_return fail(moved);
  if (!told) co_return fail(told);
  co_return answer(true);
}

}  // namespace pizarra::robot
