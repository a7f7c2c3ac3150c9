#include "drivers/simulation/controllers/arms/ur_programs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "drivers/arm/route.hpp"
#include "drivers/simulation/controllers/arms/straight_way.hpp"
#include "drivers/simulation/controllers/arms/ur_interface.hpp"
#include "lisp/numbers.hpp"

namespace pizarra::simulation {

namespace {

arm::Joints five_of(const std::array<double, 6>& q) {
  return {degrees(q[0]), degrees(q[1]), degrees(q[2]), degrees(q[3]), degrees(q[5])};
}

bool is_move(const UrStep& step) {
  return step.kind == UrStep::Kind::move_joints || step.kind == UrStep::Kind::move_line;
}

// The grip centre, where the flange is to be there: m and a rotation vector.
arm::ToolPose grip_of(const arm::ArmModel& model, const UrValue& pose) {
  arm::ToolPose grip = arm::ToolPose::Identity();
  const Eigen::Vector3d turn(pose[3], pose[4], pose[5]);
  if (turn.norm() > 0) grip.linear() = Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
  grip.translation() = 1000 * Eigen::Vector3d(pose[0], pose[1], pose[2]) + model.tool_mm * grip.linear().col(2);
  return grip;
}

// None where the arm cannot go there: wrist 2 stands, and axes have limits.
std::optional<arm::Joints> joints_of(const arm::ArmModel& model, const UrStep& step, const arm::Joints& near) {
  if (step.pose) {
    const Result<arm::Joints> joints = arm::inverse(model, grip_of(model, step.target), near);
    return joints ? std::optional(*joints) : std::nullopt;
  }
  const arm::Joints joints = five_of(step.target);
  const bool can = std::abs(degrees(step.target[4]) + 90) <= 0.1 && arm::check_limits(model, joints);
  return can ? std::optional(joints) : std::nullopt;
}

// A program's name, as its first line has it.
std::string name_in(std::string_view program) {
  const std::size_t begin = program.find_first_not_of(" \t\r\n");
  const std::string_view line = begin == std::string_view::npos ? "" : program.substr(begin);
  if (!line.starts_with("def ")) return "unnamed";
  return std::string(line.substr(4, line.find('(') - 4));
}

// Those of the waypoints that the arm has still to pass, from where it stands on its way.
std::vector<arm::Joints> left_of(const std::vector<arm::Joints>& waypoints, arm::Joints from, const arm::Joints& at) {
  std::size_t next = 0;
  double nearest = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < waypoints.size(); ++i) {
    double along = 0, length = 0, off = 0;
    for (std::size_t axis = 0; axis < at.size(); ++axis) {
      along += (at[axis] - from[axis]) * (waypoints[i][axis] - from[axis]);
      length += (waypoints[i][axis] - from[axis]) * (waypoints[i][axis] - from[axis]);
    }
    const double part = length > 0 ? std::clamp(along / length, 0.0, 1.0) : 0;
    for (std::size_t axis = 0; axis < at.size(); ++axis) {
      off += std::pow(at[axis] - std::lerp(from[axis], waypoints[i][axis], part), 2);
    }
    if (off < nearest) {
      nearest = off;
      next = i;
    }
    from = waypoints[i];
  }
  return {waypoints.begin() + static_cast<std::ptrdiff_t>(next), waypoints.end()};
}

}  // namespace

void UrPrograms::run(std::string_view program) {
  const Result<std::vector<UrStep>> steps = read_urscript(program);
  if (!steps) {
    const Datum& line = steps.error().subject;
    const auto number = static_cast<std::int32_t>(line.number());
    messages_.say(ur_exception_message(messages_.now_us(), number, steps.error().sentence));
    return;
  }
  if (program.starts_with("sec ")) {
    for (const UrStep& step : *steps) set(step);
    return;
  }
  if (cabinet_.servo()) start(name_in(program), *steps);
}

void UrPrograms::end_soon() { ending_ = executor_.spawn(end()); }

void UrPrograms::start(std::string name, std::vector<UrStep> steps) {
  forget();
  name_ = std::move(name);
  messages_.say(ur_key_message(messages_.now_us(), "PROGRAM_XXX_STARTED", name_));
  running_ = executor_.spawn(carry_out(std::move(steps)));
}

// The one that runs, where one does.
void UrPrograms::forget() {
  running_ = Job();
  if (phase_ != Phase::stopped) messages_.say(ur_key_message(messages_.now_us(), "PROGRAM_XXX_STOPPED", name_));
  phase_ = Phase::stopped;
}

Task<void> UrPrograms::end() {
  forget();
  co_await cabinet_.stop();
}

std::string UrPrograms::load(std::string_view name) {
  const std::optional<std::string> text = stored_ ? stored_(name) : std::nullopt;
  if (!text) return "File not found: " + std::string(name);
  Result<std::vector<UrStep>> steps = read_urscript(*text);
  if (!steps) return "Error while loading program: " + std::string(name);
  forget();
  loaded_ = std::move(*steps);
  name_ = name.substr(name.find_last_of('/') + 1);
  return "Loading program: " + std::string(name);
}

// Begins the loaded program, or goes on with one that pauses.
bool UrPrograms::play() {
  if (phase_ == Phase::paused) {
    phase_ = Phase::playing;
    return true;
  }
  if (!loaded_ || !cabinet_.servo() || phase_ != Phase::stopped) return false;
  start(name_, *loaded_);
  return true;
}

Task<bool> UrPrograms::pause() {
  if (phase_ != Phase::playing) co_return false;
  phase_ = Phase::paused;
  co_await cabinet_.stop();
  co_return true;
}

Task<void> UrPrograms::while_paused() {
  while (phase_ == Phase::paused) co_await sleep(executor_, look_again);
}

void UrPrograms::set(const UrStep& step) {
  if (step.kind == UrStep::Kind::set) values_.set(step.field, step.value);
  if (step.kind == UrStep::Kind::text) messages_.say(ur_text_message(messages_.now_us(), step.field));
  if (step.kind != UrStep::Kind::digital_output) return;
  values_.set_output(step.number, step.value != 0);
}

Task<void> UrPrograms::carry_out(std::vector<UrStep> steps) {
  phase_ = Phase::playing;
  // What the program before had begun ends first.
  arm::ArmReading reading = co_await cabinet_.read();
  if (reading.moving) co_await cabinet_.stop();
  while (reading.moving) {
    co_await sleep(executor_, look_again);
    reading = co_await cabinet_.read();
  }
  bool goes_on = true;
  for (std::size_t i = 0; i < steps.size() && goes_on; ++i) {
    co_await while_paused();
    const UrStep& step = steps[i];
    if (is_move(step)) {
      std::size_t end = i;
      while (end < steps.size() && is_move(steps[end])) ++end;
      std::vector<UrStep> moves(steps.begin() + static_cast<std::ptrdiff_t>(i),
                                steps.begin() + static_cast<std::ptrdiff_t>(end));
      goes_on = co_await move(std::move(moves));
      i = end - 1;
    } else if (step.kind == UrStep::Kind::sleep) {
      co_await wait(std::chrono::duration_cast<Duration>(std::chrono::duration<double>(step.value)));
    } else {
      set(step);
    }
  }
  constexpr std::int32_t unknown_line = 1;
  if (!goes_on)
    messages_.say(ur_exception_message(messages_.now_us(), unknown_line, "the arm cannot go there, or was stopped"));
  phase_ = Phase::stopped;
  messages_.say(ur_key_message(messages_.now_us(), "PROGRAM_XXX_STOPPED", name_));
}

// Time that passes while the program pauses does not count.
Task<void> UrPrograms::wait(Duration left) {
  while (left > Duration::zero()) {
    const Duration slice = std::min(left, look_again);
    co_await sleep(executor_, slice);
    if (phase_ != Phase::paused) left -= slice;
  }
}

// Moves that follow one another are blended into one. False where the arm did not get there.
Task<bool> UrPrograms::move(std::vector<UrStep> moves) {
  const arm::ArmModel& model = cabinet_.model();
  const arm::ArmReading before = co_await cabinet_.read();
  std::vector<arm::Joints> waypoints;
  arm::Joints at = before.joints;
  double part = 1;
  for (const UrStep& step : moves) {
    const std::optional<arm::Joints> there = joints_of(model, step, at);
    if (!there) co_return false;
    const arm::Joints& to = *there;
    if (step.kind == UrStep::Kind::move_line) {
      const arm::ToolPose end = arm::forward(model, to);
      const double mm = (end.translation() - arm::forward(model, at).translation()).norm();
      const double mm_s = step.time_s > 0 ? mm / step.time_s : step.speed * 1000;
      if (mm_s <= 0) continue;
      const Result<StraightWay> way = straight_way(model, at, end, mm_s);
      if (!way) co_return false;
      waypoints.insert(waypoints.end(), way->waypoints.begin(), way->waypoints.end());
      part = std::min(part, way->part);
    } else {
      double furthest = 0;
      for (std::size_t axis = 0; axis < to.size(); ++axis) furthest = std::max(furthest, std::abs(to[axis] - at[axis]));
      const double wanted_s = step.time_s > 0 ? step.time_s : radians(furthest) / step.speed;
      if (wanted_s > 0) part = std::min(part, std::max(1e-3, arm::seconds_between(model, at, to) / wanted_s));
    }
    waypoints.push_back(to);
    at = to;
  }
  arm::Joints from = before.joints;
  while (!waypoints.empty()) {
    co_await while_paused();
    const Refusal refusal = co_await cabinet_.move(waypoints, part);
    if (refusal != Refusal::none) co_return false;
    arm::ArmReading reading = co_await cabinet_.read();
    while (reading.moving) {
      co_await sleep(executor_, look_again);
      reading = co_await cabinet_.read();
    }
    if (!reading.stopped) co_return true;
    if (phase_ != Phase::paused) co_return false;
    waypoints = left_of(waypoints, from, reading.joints);
    from = reading.joints;
  }
  co_return true;
}

}  // namespace pizarra::simulation
