#include "drivers/simulation/simulated_arm.hpp"

#include <cmath>

namespace pizarra::simulation {

namespace {

constexpr Duration answer_time = 2s;

std::unexpected<Failure> odd_answer(const Datum& answer) {
  return fail("disconnected", "the arm's controller answered nonsense", answer);
}

Datum joints_to_datum(const arm::Joints& joints) {
  std::vector<Datum> out;
  for (const double angle : joints) out.push_back(Datum::real(angle));
  return Datum::list(std::move(out));
}

arm::ArmTrouble trouble_of(const Datum& alarm) {
  return {arm::ArmTrouble::Kind::fault,
          {"not-in-control", "the controller has an alarm", alarm.size() > 1 ? alarm[1] : alarm, {}}};
}

bool finite(const std::vector<arm::Joints>& waypoints) {
  for (const arm::Joints& joints : waypoints) {
    for (const double angle : joints) {
      if (!std::isfinite(angle)) return false;
    }
  }
  return true;
}

}  // namespace

Task<Result<void>> SimulatedArm::command(Datum request) {
  const Result<Message> answer = co_await link_.call(request, answer_time);
  if (answer) co_return Result<void>();
  // A number as subject is an alarm's code: whoever commands the arm says whether it may be reset.
  const bool no_alarm = answer.error().symbol == "not-in-control" && !answer.error().subject.is_number();
  const bool forgotten = after_loss_ == AfterLoss::take_control && had_control_ && no_alarm;
  if (!forgotten) co_return fail(answer);
  // A world that began anew has forgotten who had control of its arm.
  const Datum taking = list(device_, "take-control"_sym);
  const Result<Message> taken = co_await link_.call(taking, answer_time);
  if (!taken) co_return fail(taken);
  const Result<Message> again = co_await link_.call(request, answer_time);
  if (!again) co_return fail(again);
  co_return Result<void>();
}

Task<Result<std::string>> SimulatedArm::identify() {
  const Datum request = list(device_, "identify"_sym);
  const Result<Message> answer = co_await link_.call(request, answer_time);
  if (!answer) co_return fail(answer);
  if (answer->head.size() != 1) co_return odd_answer(answer->head);
  co_return std::string(answer->head[0].text());
}

Task<Result<void>> SimulatedArm::take_control() {
  Datum request = list(device_, "take-control"_sym);
  Result<void> taken = co_await command(std::move(request));
  had_control_ = had_control_ || taken.has_value();
  co_return taken;
}

Task<Result<void>> SimulatedArm::release_control() {
  had_control_ = false;
  Datum request = list(device_, "release-control"_sym);
  co_return co_await command(std::move(request));
}

Task<Result<void>> SimulatedArm::start_move(std::vector<arm::Joints> waypoints, double speed) {
  const bool sound = std::isfinite(speed) && finite(waypoints);
  if (!sound) co_return fail("not-finite", "a joint angle or the speed is not a number");
  std::vector<Datum> request{device_, "move"_sym, Datum::real(speed)};
  for (const arm::Joints& joints : waypoints) request.push_back(joints_to_datum(joints));
  Datum form = Datum::list(std::move(request));
  co_return co_await command(std::move(form));
}

Task<Result<void>> SimulatedArm::stop() { return command(list(device_, "stop"_sym)); }

Task<Result<void>> SimulatedArm::start_gripper(double opening_mm) {
  if (!std::isfinite(opening_mm)) co_return fail("not-finite", "the opening is not a number");
  Datum request = list(device_, "gripper"_sym, opening_mm);
  co_return co_await command(std::move(request));
}

Task<Result<arm::ArmReading>> SimulatedArm::read() {
  const Datum request = list(device_, "read"_sym);
  const Result<Message> answer = co_await link_.call(request, answer_time);
  if (!answer) co_return fail(answer);
  const Datum& head = answer->head;
  const bool shaped = head.size() >= 5 && head.size() <= 7 && head[0].size() >= 1 && head[0].size() <= arm::most_axes;
  if (!shaped) co_return odd_answer(head);
  arm::ArmReading reading{};
  reading.joints = arm::Joints(head[0].size());
  for (std::size_t axis = 0; axis < reading.joints.size(); ++axis) reading.joints[axis] = head[0][axis].number();
  reading.moving = head[1].is_symbol("yes");
  reading.stopped = head[2].is_symbol("yes");
  reading.opening_mm = head[3].number();
  reading.gripper_moving = head[4].is_symbol("yes");
  // An answer may be late; the guard goes by when the arm was so, where the device says it.
  for (const Datum& more : head.items().subspan(5)) {
    if (more.is_integer()) reading.at = Time(Duration(more.integer()));
    if (more.is_form("alarm")) reading.trouble = trouble_of(more);
  }
  hear_state();
  co_return reading;
}

}  // namespace pizarra::simulation
