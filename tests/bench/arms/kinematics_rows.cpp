#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <numbers>

#include "blackboard/time/random.hpp"
#include "drivers/arm/arm_file.hpp"
#include "drivers/arm/kinematics.hpp"
#include "drivers/arm/posture.hpp"
#include "lisp/forms/arm_names.hpp"
#include "tests/bench/arms/rows.hpp"
#include "tests/bench/measure.hpp"
#include "tests/source_dir.hpp"

namespace pizarra::bench {

namespace {

constexpr std::uint64_t seed = 1;
constexpr double most_mm = 0.01;
constexpr double most_deg = 0.001;

arm::Joints random_joints(const arm::ArmModel& arm, Random& random) {
  arm::Joints joints(arm.axes.size());
  for (std::size_t axis = 0; axis < joints.size(); ++axis) {
    const arm::Range range = arm::range_of(arm, joints, axis);
    joints[axis] = random.uniform(range.low, range.high);
  }
  return joints;
}

// Where the arm is when it is asked: anywhere, but with its track where the target was made.
arm::Joints random_start(const arm::ArmModel& arm, Random& random, const arm::Joints& target) {
  arm::Joints start = random_joints(arm, random);
  if (const auto track = arm.axis_of(arm::Role::track)) start[*track] = target[*track];
  return start;
}

struct Error {
  double mm;
  double deg;
};
Error error_of(const arm::ArmModel& arm, const arm::Joints& joints, const arm::ToolPose& wanted) {
  const arm::ToolPose got = arm::forward(arm, joints);
  const double chord = (got.linear() - wanted.linear()).norm() / std::sqrt(8.0);
  return {(got.translation() - wanted.translation()).norm(),
          2 * std::asin(std::min(1.0, chord)) * 180 / std::numbers::pi};
}

struct Move {
  arm::ToolPose pose;
  arm::Joints near;
};

void time_moves(ArmsBench& bench, const arm::ArmModel& arm) {
  constexpr std::size_t kinds = 2000;
  constexpr int times = 10;
  Random random(seed);
  std::vector<Move> moves;
  for (std::size_t i = 0; i < kinds; ++i) {
    // From one place to another a step away, as along a line.
    const arm::Joints from = random_joints(arm, random);
    arm::Joints to = from;
    for (std::size_t axis = 0; axis < to.size(); ++axis) {
      if (arm.axes[axis].role == arm::Role::track) continue;
      const arm::Range range = arm::range_of(arm, to, axis);
      to[axis] = std::clamp(to[axis] + random.uniform(-1, 1), range.low, range.high);
    }
    moves.push_back({arm::forward(arm, to), from});
  }
  double sum = 0;
  const std::vector<double> seconds =
      medians_of_rounds(9, {[&] {
                          // Other work on this core is not counted as the arm's.
                          return thread_seconds_of([&] {
                            for (int i = 0; i < times; ++i) {
                              for (const Move& move : moves)
                                sum += arm::inverse_in_place(arm, move.pose, move.near).value_or(arm::Joints(1))[0];
                            }
                          });
                        }});
  const double us = seconds.front() * 1e6 / (times * static_cast<double>(kinds));
  bench.figures.say(
      {arm.type + ": inverse of one move", us, "us", at_most(5), {}, std::isnan(sum) ? "not a number" : ""});
}

void try_reachable(ArmsBench& bench, const arm::ArmModel& arm) {
  Random random(seed);
  std::uint64_t solved = 0;
  Error worst{0, 0};
  for (std::uint64_t i = 0; i < bench.targets; ++i) {
    const arm::Joints there = random_joints(arm, random);
    const arm::ToolPose pose = arm::forward(arm, there);
    const Result<arm::Joints> joints = arm::inverse(arm, pose, random_start(arm, random, there));
    if (!joints || !arm::check_limits(arm, *joints)) continue;
    const Error error = error_of(arm, *joints, pose);
    worst = {std::max(worst.mm, error.mm), std::max(worst.deg, error.deg)};
    if (error.mm <= most_mm && error.deg <= most_deg) ++solved;
  }
  const auto all = static_cast<double>(bench.targets);
  bench.figures.say({arm.type + ": reachable targets solved",
                     static_cast<double>(solved),
                     "targets",
                     at_least(all, fmt::format("all {}", bench.targets)),
                     {},
                     fmt::format("worst {:.1e} mm, {:.1e} degree", worst.mm, worst.deg)});
}

// Targets far out with any direction, so that most cannot be reached: what is accepted must be reached all the same.
void try_unreachable(ArmsBench& bench, const arm::ArmModel& arm) {
  Random random(seed + 1);
  std::uint64_t refused = 0;
  std::uint64_t wrong = 0;
  constexpr double out_of_all_reach_mm = 20'000;
  for (std::uint64_t i = 0; i < bench.targets; ++i) {
    const bool far = i % 2 == 0;
    const arm::Joints there = random_joints(arm, random);
    arm::ToolPose pose = arm::forward(arm, there);
    Eigen::Vector3d offset(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    pose.translation() +=
        far ? Eigen::Vector3d(offset.normalized() * out_of_all_reach_mm) : Eigen::Vector3d(offset * 1000);
    const Result<arm::Joints> joints = arm::inverse_in_place(arm, pose, there);
    if (!joints) {
      ++refused;
      continue;
    }
    const Error error = error_of(arm, *joints, pose);
    if (far || error.mm > most_mm || error.deg > most_deg || !arm::check_limits(arm, *joints)) ++wrong;
  }
  bench.figures.say({arm.type + ": unreachable targets accepted",
                     static_cast<double>(wrong),
                     "targets",
                     at_most(0),
                     {},
                     fmt::format("{} of {} refused", refused, bench.targets)});
}

std::vector<arm::ArmModel> arms() {
  std::vector<arm::ArmModel> all;
  for (const std::string& name : forms::arm_names()) all.push_back(arm::shipped_arm(name).value());
  return all;
}

int lines_of_code(const std::filesystem::path& path) {
  std::ifstream file(path);
  int lines = 0;
  for (std::string line; std::getline(file, line);) {
    const std::size_t begin = line.find_first_not_of(" \t");
    if (begin != std::string::npos && line.substr(begin, 2) != "//") ++lines;
  }
  return lines;
}

}  // namespace

void one_move(ArmsBench& bench) {
  for (const arm::ArmModel& arm : arms()) time_moves(bench, arm);
}

void random_targets(ArmsBench& bench) {
  for (const arm::ArmModel& arm : arms()) {
    try_reachable(bench, arm);
    try_unreachable(bench, arm);
  }
}

void lines_of_description(ArmsBench& bench) {
  for (const std::string& name : forms::arm_names()) {
    std::ifstream file(forms::shipped_arm_file(name));
    int lines = 0;
    for (std::string line; std::getline(file, line);) ++lines;
    bench.figures.say({name + ": description", lines, "lines", at_most(59, "< 60")});
  }
  const std::string folder = source_dir() + "/drivers/arm/universal";
  int driver = 0;
  int messages = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string file = entry.path().filename().string();
    if (!file.ends_with("pp")) continue;
    (file.starts_with("universal_arm") ? driver : messages) += lines_of_code(entry.path());
  }
  bench.figures.say(
      {"Universal Robots: driver with its protocol's messages",
       driver + messages,
       "lines",
       at_most(199, "< 200"),
       {},
       fmt::format("without blank lines and comments; the driver {}, messages and programs {}", driver, messages)});
}

}  // namespace pizarra::bench
