#include "agents/robot/arm_facts.hpp"

#include <algorithm>
#include <cmath>

#include "blackboard/away.hpp"
#include "drivers/arm/kinematics.hpp"
#include "lisp/numbers.hpp"

namespace pizarra::robot {

namespace {

constexpr double parts_of_mm = 100;
constexpr double parts_of_degree = 1000;
constexpr double parts_of_opening_mm = 10;

}  // namespace

std::vector<Datum> pose_numbers(const arm::ArmModel& model, const arm::Joints& joints) {
  const arm::ToolPose at = arm::forward(model, joints);
  std::vector<Datum> numbers;
  for (const double mm : at.translation()) numbers.push_back(to_datum(rounded(mm, parts_of_mm)));
  for (const double deg : arm::fixed_angles(at.linear())) {
    const double angle = rounded(deg, parts_of_degree);
    numbers.push_back(to_datum(angle <= -180 ? 180.0 : angle));
  }
  return numbers;
}

std::vector<Datum> joint_numbers(const arm::Joints& joints) {
  std::vector<Datum> numbers;
  for (const double reading : joints) numbers.push_back(to_datum(rounded(reading, parts_of_degree)));
  return numbers;
}

std::vector<Datum> foot_numbers(const arm::ArmModel& model, const arm::Joints& joints) {
  const bool turns = model.axis_of(arm::Role::turn).has_value();
  const Eigen::Vector3d foot = turns ? arm::skeleton(model, joints).front() : Eigen::Vector3d::Zero();
  return {to_datum(rounded(foot.x(), parts_of_mm)), to_datum(rounded(foot.y(), parts_of_mm))};
}

Datum joints_to_datum(const arm::Joints& joints) {
  std::vector<Datum> numbers;
  for (const double deg : joints) numbers.push_back(to_datum(deg));
  return Datum::list(std::move(numbers));
}

std::optional<arm::Joints> joints_from_datum(const Datum& datum) {
  const bool some = datum.size() > 0 && datum.size() <= arm::most_axes;
  if (!some || !std::ranges::all_of(datum.items(), &Datum::is_number)) return std::nullopt;
  arm::Joints joints(datum.size());
  std::ranges::transform(datum.items(), joints.begin(), &Datum::number);
  return joints;
}

void ArmFacts::set_arm(std::string_view state, std::string action) {
  state_ = state;
  action_ = std::move(action);
  set_state_fact();
}

void ArmFacts::set_trouble(std::optional<arm::ArmTrouble> trouble) {
  trouble_ = std::move(trouble);
  if (!state_.empty()) set_state_fact();
}

void ArmFacts::set_state_fact() {
  facts_[arm].now = list("arm"_sym, robot_, Datum::symbol(state_), action_);
  if (!trouble_ || state_ == "moving") return;
  const Datum state = trouble_->kind == arm::ArmTrouble::Kind::fault ? "fault"_sym : "stopped"_sym;
  facts_[arm].now = list("arm"_sym, robot_, state, trouble_->why.sentence);
}

void ArmFacts::set_reading(const arm::ArmModel& model, const arm::ArmReading& reading) {
  set_trouble(reading.trouble);
  std::vector<Datum> at = pose_numbers(model, reading.joints);
  at.insert(at.begin(), {"arm-pose"_sym, robot_});
  facts_[pose].now = Datum::list(std::move(at));
  std::vector<Datum> stands = foot_numbers(model, reading.joints);
  stands.insert(stands.begin(), {"arm-foot"_sym, robot_});
  facts_[foot].now = Datum::list(std::move(stands));
  facts_[joints].now = list("arm-joints"_sym, robot_, Datum::list(joint_numbers(reading.joints)));
  if (reading.gripper_trouble) {
    facts_[gripper].now = facts_[gripped].now = Datum();
    return;
  }
  facts_[gripper].now = list("gripper"_sym, robot_, rounded(reading.opening_mm, parts_of_opening_mm));
  if (reading.gripped) facts_[gripped].now = list("gripped"_sym, robot_, *reading.gripped ? "yes"_sym : "no"_sym);
}

void ArmFacts::forget_reading() {
  for (const std::size_t kind : {pose, foot, joints, gripper, gripped}) facts_[kind].now = Datum();
}

bool ArmFacts::changed() const {
  return std::ranges::any_of(facts_, [](const Told& fact) { return fact.now != fact.told; });
}

Datum ArmFacts::pattern(std::size_t kind) const {
  constexpr std::pair<std::string_view, std::size_t> shapes[kinds] = {
      {"arm", 2}, {"arm-pose", 6}, {"arm-foot", 2}, {"arm-joints", 1}, {"gripper", 1}, {"gripped", 1}};
  std::vector<Datum> form(2 + shapes[kind].second, "?"_sym);
  form[0] = Datum::symbol(shapes[kind].first);
  form[1] = robot_;
  return Datum::list(std::move(form));
}

Task<Result<void>> ArmFacts::tell(Transaction with) {
  const LeaseId presence = service_.presence();
  // A board that began anew, or let the presence lapse, knows nothing of what was told before.
  if (presence != told_under_) forget_told();
  const std::array<Told, kinds> sent = facts_;
  for (std::size_t kind = 0; kind < kinds; ++kind) {
    const Told& fact = sent[kind];
    if (fact.now == fact.told) continue;
    if (fact.now.size() > 0) {
      with.tell(fact.now, {}, presence);
    } else {
      with.retract(pattern(kind));
    }
  }
  if (with.steps.empty()) co_return {};
  const Result<Revision> told = if_it_stands(co_await context_.board.transact(std::move(with)));
  if (!told) co_return fail(told);
  told_under_ = presence;
  for (std::size_t kind = 0; kind < kinds; ++kind) facts_[kind].told = sent[kind].now;
  co_return {};
}

Task<Result<void>> ArmFacts::tell_surely(Transaction with) {
  while (true) {
    const Result<void> told = co_await tell(with);
    if (told) co_return told;
    // A presence that has lapsed is announced anew before long.
    const bool passing = is_away(told.error()) || told.error().symbol == "unknown-lease";
    if (!passing) co_return told;
    co_await sleep(context_.executor, retry_pause);
  }
}

void ArmFacts::forget_told() {
  for (Told& fact : facts_) {
    if (fact.told != Datum()) fact.told.reset();
  }
}

}  // namespace pizarra::robot
