#include "agents/robot/moving_operations.hpp"

#include <algorithm>

#include "agents/robot/carry.hpp"
#include "agents/robot/jog.hpp"
#include "agents/runtime/hold_deadlines.hpp"
#include "lisp/writer.hpp"

namespace pizarra::robot {

namespace {

constexpr double max_opening_mm = 100;
// Fingers that stand so much wider than they were sent have something between them.
constexpr double widened_mm = 3;

}  // namespace

bool MovingOperations::has(const Datum& operation) {
  return is_motion(operation) || operation.is_form("jog") || operation.is_form("gripper");
}

Task<Result<Datum>> MovingOperations::run(Fact request) {
  if (request.datum[3].is_form("jog")) return jog(std::move(request));
  if (request.datum[3].is_form("gripper")) return grip(std::move(request));
  return move(std::move(request));
}

bool MovingOperations::holds_something(const arm::ArmReading& reading) const {
  if (reading.gripped) return *reading.gripped;
  return fingers_sent_mm_ && reading.opening_mm > *fingers_sent_mm_ + widened_mm;
}

Task<Result<Datum>> MovingOperations::move(Fact request) {
  const Datum operation = request.datum[3];
  const Result<InHand> in_hand = robot_.control.take_in_hand(request.datum);
  if (!in_hand) co_return fail(in_hand);
  const Result<arm::ArmReading> reading = co_await robot_.connection.read();
  if (!reading) co_return fail(reading);
  const arm::Joints at = reading->joints;
  Result<Motion> motion = plan_motion(robot_.model, operation, at, robot_.memory.variables());
  if (!motion) co_return fail(motion);
  const Result<void> inside = check_room(robot_.model, robot_.room, at, motion->waypoints);
  if (!inside) co_return fail(inside);
  if (motion->waypoints.empty()) {
    robot_.facts.set_arm("idle", write(operation));
    const Result<void> told = co_await robot_.facts.tell_surely();
    if (!told) co_return fail(told);
    co_return done_answer(!motion->at_limit);
  }
  double speed_part = robot_.memory.speed_percent() / 100;
  if (holds_something(*reading)) speed_part = std::min(speed_part, carry_speed(robot_.model, at, motion->waypoints));
  Task<Result<void>> following = robot_.control.follow(at, std::move(motion->waypoints), speed_part);
  co_return co_await carry_out(std::move(request), std::move(following));
}

Task<Result<Datum>> MovingOperations::jog(Fact request) {
  const Datum operation = request.datum[3];
  const double least_ms = std::chrono::duration<double, std::milli>(runtime::least_hold_deadline).count();
  const double longest_ms = std::chrono::duration<double, std::milli>(runtime::longest_hold_deadline).count();
  const Result<double> given_ms = amount_in(operation[2], least_ms, longest_ms, "ms");
  if (!given_ms) co_return fail(given_ms);
  const auto deadline = std::chrono::duration_cast<Duration>(std::chrono::duration<double, std::milli>(*given_ms));
  const Result<InHand> in_hand = robot_.control.take_in_hand(request.datum);
  if (!in_hand) co_return fail(in_hand);
  const Result<void> held = co_await robot_.holds.await(request.teller, deadline);
  if (!held) co_return fail(held);
  const Result<arm::ArmReading> reading = co_await robot_.connection.read();
  if (!reading) co_return fail(reading);
  const arm::Joints at = reading->joints;
  Result<Motion> motion = plan_jog(robot_.model, robot_.room, operation[1].text(), at);
  if (!motion) co_return fail(motion);
  if (motion->at_limit) co_return done_answer(false);
  Task<Result<void>> following = follow_while_held(request.teller, deadline, at, std::move(motion->waypoints));
  co_return co_await carry_out(std::move(request), std::move(following));
}

// To let go is how a jog ends.
Task<Result<void>> MovingOperations::follow_while_held(std::string client, Duration deadline, arm::Joints from,
                                                       std::vector<arm::Joints> waypoints) {
  const Result<void> held = co_await robot_.holds.await(client, deadline);
  if (!held) co_return held;
  const double speed_part =
      std::min(robot_.memory.speed_percent() / 100, jog_speed(robot_.model, from, waypoints, deadline));
  const Holds::Watching watching(robot_.holds, client, deadline);
  Result<void> moved = co_await robot_.control.follow(from, std::move(waypoints), speed_part);
  const bool released = !moved && moved.error().symbol == Holds::released;
  if (released) co_return Result<void>();
  co_return moved;
}

Task<Result<Datum>> MovingOperations::grip(Fact request) {
  const Datum operation = request.datum[3];
  const Result<double> opening_mm = clamped_amount(operation[1], max_opening_mm, "mm");
  if (!opening_mm) co_return fail(opening_mm);
  const Result<InHand> in_hand = robot_.control.take_in_hand(request.datum);
  if (!in_hand) co_return fail(in_hand);
  fingers_sent_mm_ = *opening_mm;
  Task<Result<void>> gripping = robot_.control.grip(*opening_mm);
  co_return co_await carry_out(std::move(request), std::move(gripping));
}

// The board has it before anything moves, a round trip, and how it ended before it is answered: whenever this agent
// dies, its successor knows what to answer, and moves nothing twice.
Task<Result<Datum>> MovingOperations::carry_out(Fact request, Task<Result<void>> motion) {
  const Datum& id = request.datum[1];
  robot_.facts.set_arm("moving", write(request.datum[3]));
  Transaction begin;
  robot_.memory.add_begin(begin, id);
  const Result<void> begun = co_await robot_.facts.tell_surely(std::move(begin));
  if (!begun) {
    robot_.facts.set_arm("idle");
    co_return fail(begun);
  }
  const Reflex::Watching watching(robot_.reflex, request.teller, robot_.service.presence());
  // Anything may have been said meanwhile.
  Result<void> moved = robot_.reflex.allows(request.teller);
  if (moved) moved = co_await motion;
  if (moved) robot_.facts.set_arm("idle");
  if (!moved && robot_.connection.is_there()) {
    const bool stopped = robot_.control.was_stopped() || moved.error().symbol == "stopped";
    robot_.facts.set_arm(moved.error().symbol == "fault" ? "fault" : stopped ? "stopped" : "idle");
  }
  Transaction end;
  robot_.memory.add_end(end, id, moved);
  const Result<void> told = co_await robot_.facts.tell_surely(std::move(end));
  if (!moved) co_return fail(moved);
  if (!told) co_return fail(told);
  co_return done_answer(true);
}

}  // namespace pizarra::robot
