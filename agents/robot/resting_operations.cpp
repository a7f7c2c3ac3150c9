// The operations of the robot agent that move nothing.

#include <fmt/format.h>

#include "agents/robot/robot_state.hpp"

namespace pizarra::robot {

namespace {

constexpr std::size_t max_variables = 256;

}  // namespace

Task<Result<Datum>> RobotAgent::State::answer_monitor(Datum operation) {
  if (operation.is_form("monitor")) return monitor();
  if (operation.is_form("finish")) return finish(std::move(operation));
  return get_status();
}

Task<Result<Datum>> RobotAgent::State::get_status() { co_return list(facts.action()); }

Task<Result<Datum>> RobotAgent::State::speed(Datum operation) {
  const Result<double> percent = amount_in(operation[1], 1, 100, "percent");
  if (!percent) co_return fail(percent);
  const Datum fact = list("robot-speed"_sym, name, *percent);
  const Result<Revision> told = if_it_stands(co_await context.board.tell(fact));
  if (!told) co_return fail(told);
  speed_percent = *percent;
  co_return answer(true);
}

Task<Result<Datum>> RobotAgent::State::learn(Datum operation) {
  const std::string variable(operation[1].text());
  if (!variables.contains(variable) && variables.size() >= max_variables) {
    co_return fail("out-of-range", fmt::format("{} variables are learned already", max_variables), operation[1]);
  }
  const Result<arm::ArmReading> reading = co_await connection.read();
  if (!reading) co_return fail(reading);
  const Datum fact = list("robot-variable"_sym, name, operation[1], joints_to_datum(reading->joints));
  const Result<Revision> told = if_it_stands(co_await context.board.tell(fact));
  if (!told) co_return fail(told);
  variables.insert_or_assign(variable, reading->joints);
  co_return answer(true);
}

Task<Result<Datum>> RobotAgent::State::monitor() {
  const Result<arm::ArmReading> reading = co_await connection.read();
  if (!reading) co_return fail(reading);
  std::vector<Datum> numbers = pose_numbers(model, reading->joints);
  const std::vector<Datum> joints = joint_numbers(reading->joints);
  numbers.insert(numbers.end(), joints.begin(), joints.end());
  co_return Datum::list(std::move(numbers));
}

Task<Result<Datum>> RobotAgent::State::finish(Datum operation) {
  const bool reports = operation[1].is_symbol("report");
  if (!reports && !operation[1].is_symbol("stop")) {
    co_return fail("wrong-direction", "finish takes report or stop", operation[1]);
  }
  const bool named = operation.size() > 2;
  const bool is_its_own = control.running() && (!named || control.request() == operation[2]);
  if (reports) co_return answer(!is_its_own);
  if (control.running() && !is_its_own) co_return fail(control.busy());
  // What has ended is not stopped.
  if (named && !is_its_own) co_return answer(true);
  const Result<void> stopped = co_await control.stop(operation);
  if (!stopped) co_return fail(stopped);
  co_return answer(true);
}

Task<Result<Datum>> RobotAgent::State::get_control(Datum operation) {
  const Result<InHand> in_hand = control.occupy(operation);
  if (!in_hand) co_return fail(in_hand);
  const Result<void> taken = co_await connection.get_control();
  if (!taken) co_return fail(taken);
  Transaction taking;
  taking.retract(released_fact("?"_sym));
  const Result<void> told = co_await facts.tell_surely(std::move(taking));
  if (!told) co_return fail(told);
  co_return answer(true);
}

// The board has it before the servos go off: a successor of this agent leaves them off.
Task<Result<Datum>> RobotAgent::State::release_control(Fact request) {
  const Result<InHand> in_hand = control.occupy(request.datum[3]);
  if (!in_hand) co_return fail(in_hand);
  Transaction releasing;
  releasing.tell(released_fact(Datum::symbol(request.teller)));
  const Result<void> kept = co_await facts.tell_surely(std::move(releasing));
  if (!kept) co_return fail(kept);
  connection.set_released(request.teller);
  const Result<void> released = co_await connection.release_control();
  if (!released) co_return fail(released);
  const Result<void> told = co_await facts.tell_surely();
  if (!told) co_return fail(told);
  co_return answer(true);
}

}  // namespace pizarra::robot
