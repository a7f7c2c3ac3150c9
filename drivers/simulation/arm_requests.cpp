#include "drivers/simulation/arm_requests.hpp"

#include "drivers/simulation/hand_request.hpp"

namespace pizarra::simulation {

namespace {

Datum yes_no(bool value) { return value ? "yes"_sym : "no"_sym; }

Datum joints_to_datum(const arm::Joints& joints) {
  std::vector<Datum> out;
  for (const double angle : joints) out.push_back(Datum::real(angle));
  return Datum::list(std::move(out));
}

Result<arm::Joints> joints_from_datum(const Datum& datum) {
  if (datum.size() < 1 || datum.size() > arm::most_axes) return bad_request(datum);
  arm::Joints joints(datum.size());
  for (std::size_t axis = 0; axis < joints.size(); ++axis) {
    if (!datum[axis].is_number()) return bad_request(datum);
    joints[axis] = datum[axis].number();
  }
  return joints;
}

// Of (ARM move SPEED (J1 ... JN) ...).
Result<std::vector<arm::Joints>> waypoints_of(const Datum& request) {
  if (request.size() < 4 || !request[2].is_number()) return bad_request(request);
  std::vector<arm::Joints> waypoints;
  for (const Datum& item : request.items().subspan(3)) {
    const Result<arm::Joints> joints = joints_from_datum(item);
    if (!joints) return fail(joints);
    waypoints.push_back(*joints);
  }
  return waypoints;
}

Result<Message> done(const Result<void>& result) {
  if (!result) return fail(result);
  return Message{};
}

}  // namespace

Task<Result<std::string>> PhysicalArm::identify() { co_return type_; }

Task<Result<void>> PhysicalArm::take_control() {
  controlled_ = true;
  co_return Result<void>();
}

Task<Result<void>> PhysicalArm::release_control() {
  controlled_ = false;
  co_return Result<void>();
}

Result<void> PhysicalArm::controlled() const {
  if (!controlled_) return fail("not-in-control", "nobody has taken control of the arm");
  return {};
}

Task<Result<void>> PhysicalArm::start_move(std::vector<arm::Joints> waypoints, double speed) {
  const Result<void> allowed = controlled();
  if (!allowed) co_return allowed;
  co_return cell_.arm().start(std::move(waypoints), speed);
}

Task<Result<void>> PhysicalArm::stop() {
  cell_.arm().brake();
  co_return Result<void>();
}

Task<Result<void>> PhysicalArm::start_gripper(double opening_mm) {
  const Result<void> allowed = controlled();
  if (!allowed) co_return allowed;
  cell_.gripper().command(opening_mm);
  co_return Result<void>();
}

Task<Result<arm::ArmReading>> PhysicalArm::read() {
  arm::ArmReading reading{.joints = cell_.arm().joints(),
                          .moving = cell_.arm().moving(),
                          .stopped = cell_.arm().stopped(),
                          .opening_mm = cell_.gripper().opening_mm(),
                          .gripper_moving = cell_.gripper().moving()};
  co_return reading;
}

Task<Result<Message>> answer_arm(arm::ArmDriver& arm, Datum request, Time now) {
  const std::string_view what = word(request, 1);
  if (what == "identify") {
    const Result<std::string> type = co_await arm.identify();
    if (!type) co_return fail(type);
    co_return Message{list(*type)};
  }
  if (what == "read") {
    const Result<arm::ArmReading> reading = co_await arm.read();
    if (!reading) co_return fail(reading);
    co_return Message{list(joints_to_datum(reading->joints), yes_no(reading->moving), yes_no(reading->stopped),
                           reading->opening_mm, yes_no(reading->gripper_moving), now.time_since_epoch().count())};
  }
  if (what == "move") {
    Result<std::vector<arm::Joints>> waypoints = waypoints_of(request);
    if (!waypoints) co_return fail(waypoints);
    const double speed = request[2].number();
    const Result<void> started = co_await arm.start_move(std::move(*waypoints), speed);
    co_return done(started);
  }
  if (what == "gripper") {
    if (request.size() != 3 || !request[2].is_number()) co_return bad_request(request);
    const double opening_mm = request[2].number();
    const Result<void> started = co_await arm.start_gripper(opening_mm);
    co_return done(started);
  }
  if (what == "take-control") {
    const Result<void> taken = co_await arm.take_control();
    co_return done(taken);
  }
  if (what == "release-control") {
    const Result<void> released = co_await arm.release_control();
    co_return done(released);
  }
  if (what == "stop") {
    const Result<void> stopped = co_await arm.stop();
    co_return done(stopped);
  }
  co_return bad_request(request);
}

}  // namespace pizarra::simulation
