#include "agents/robot/resting_operations.hpp"

namespace pizarra::robot {

bool RestingOperations::is_open_to_all(const Datum& operation) {
  return operation.is_form("get-status") || operation.is_form("monitor") || operation.is_form("finish");
}

Task<Result<Datum>> RestingOperations::run(Fact request) {
  Datum operation = request.datum[3];
  if (operation.is_form("get-status")) return get_status();
  if (operation.is_form("monitor")) return monitor();
  if (operation.is_form("finish")) return finish(std::move(operation));
  if (operation.is_form("speed")) return speed(std::move(operation));
  if (operation.is_form("learn")) return learn(std::move(operation));
  if (operation.is_form("release-control")) return release_control(std::move(request));
  return get_control(std::move(operation));
}

Task<Result<Datum>> RestingOperations::get_status() { co_return list(robot_.facts.action()); }

Task<Result<Datum>> RestingOperations::speed(Datum operation) {
  const Result<double> percent = amount_in(operation[1], 1, 100, "percent");
  if (!percent) co_return fail(percent);
  const Result<void> kept = co_await robot_.memory.keep_speed(*percent);
  if (!kept) co_return fail(kept);
  co_return done_answer(true);
}

Task<Result<Datum>> RestingOperations::learn(Datum operation) {
  const Result<void> fits = robot_.memory.check_variable(operation[1]);
  if (!fits) co_return fail(fits);
  const Result<arm::ArmReading> reading = co_await robot_.connection.read();
  if (!reading) co_return fail(reading);
  const Result<void> kept = co_await robot_.memory.keep_variable(operation[1], reading->joints);
  if (!kept) co_return fail(kept);
  co_return done_answer(true);
}

Task<Result<Datum>> RestingOperations::monitor() {
  const Result<arm::ArmReading> reading = co_await robot_.connection.read();
  if (!reading) co_return fail(reading);
  std::vector<Datum> numbers = pose_numbers(robot_.model, reading->joints);
  const std::vector<Datum> joints = joint_numbers(reading->joints);
  numbers.insert(numbers.end(), joints.begin(), joints.end());
  co_return Datum::list(std::move(numbers));
}

Task<Result<Datum>> RestingOperations::finish(Datum operation) {
  const bool reports = operation[1].is_symbol("report");
  if (!reports && !operation[1].is_symbol("stop")) {
    co_return fail("wrong-direction", "finish takes report or stop", operation[1]);
  }
  const bool named = operation.size() > 2;
  const bool is_its_own = robot_.control.running() && (!named || robot_.control.request() == operation[2]);
  if (reports) co_return done_answer(!is_its_own);
  if (robot_.control.running() && !is_its_own) co_return fail(robot_.control.busy());
  // What has ended is not stopped.
  if (named && !is_its_own) co_return done_answer(true);
  const Result<void> stopped = co_await robot_.control.stop(operation);
  if (!stopped) co_return fail(stopped);
  co_return done_answer(true);
}

Task<Result<Datum>> RestingOperations::get_control(Datum operation) {
  const Result<InHand> in_hand = robot_.control.occupy(operation);
  if (!in_hand) co_return fail(in_hand);
  const Result<void> taken = co_await robot_.connection.get_control();
  if (!taken) co_return fail(taken);
  Transaction taking;
  robot_.memory.add_taken(taking);
  const Result<void> told = co_await robot_.facts.tell_surely(std::move(taking));
  if (!told) co_return fail(told);
  co_return done_answer(true);
}

// The board has it before the servos go off: a successor of this agent leaves them off.
Task<Result<Datum>> RestingOperations::release_control(Fact request) {
  const Result<InHand> in_hand = robot_.control.occupy(request.datum[3]);
  if (!in_hand) co_return fail(in_hand);
  Transaction releasing;
  robot_.memory.add_released(releasing, request.teller);
  const Result<void> kept = co_await robot_.facts.tell_surely(std::move(releasing));
  if (!kept) co_return fail(kept);
  robot_.connection.set_released(request.teller);
  const Result<void> released = co_await robot_.connection.release_control();
  if (!released) co_return fail(released);
  const Result<void> told = co_await robot_.facts.tell_surely();
  if (!told) co_return fail(told);
  co_return done_answer(true);
}

}  // namespace pizarra::robot
