#pragma once

// An arm that exists only in an executor's time: joint interpolation at constant speed, a gripper with something
// between its fingers or nothing, a plug that can be pulled.

#include <algorithm>
#include <cmath>

#include "blackboard/time/executor.hpp"
#include "drivers/arm/arm_driver.hpp"
#include "drivers/arm/arm_file.hpp"
#include "drivers/arm/kinematics.hpp"

namespace pizarra::robot {

class FakeArm : public arm::ArmDriver {
  Executor& executor_;
  const arm::ArmModel& model_;

 public:
  explicit FakeArm(Executor& executor, const arm::ArmModel& model = arm::crs_f3())
      : executor_(executor), model_(model), path_{model.ready} {}

  std::string type = model_.type;
  bool plugged = true;
  double between_fingers_mm = 0;
  int controls = 0;
  int moves = 0;
  std::vector<arm::Joints> last_waypoints;
  double last_speed = 0;
  bool in_control = false;
  bool gives_control = true;
  std::optional<arm::ArmTrouble> trouble;
  std::optional<bool> gripped;

  arm::Joints at() const {
    double left_s = seconds_since(begun_);
    for (std::size_t leg = 0; leg + 1 < path_.size(); ++leg) {
      const double needed_s = leg_seconds(leg);
      if (left_s >= needed_s) {
        left_s -= needed_s;
        continue;
      }
      arm::Joints joints(path_[leg].size());
      for (std::size_t axis = 0; axis < joints.size(); ++axis) {
        joints[axis] = path_[leg][axis] + (path_[leg + 1][axis] - path_[leg][axis]) * left_s / needed_s;
      }
      return joints;
    }
    return path_.back();
  }
  bool moving() const { return at() != path_.back(); }
  void put(const arm::Joints& joints) { path_ = {joints}; }

  Task<Result<std::string>> identify() override {
    if (!plugged) co_return unplugged();
    co_return type;
  }
  Task<Result<void>> take_control() override {
    if (!plugged) co_return unplugged();
    ++controls;
    in_control = gives_control;
    if (!in_control) co_return uncontrolled();
    co_return {};
  }
  Task<Result<void>> release_control() override {
    if (!plugged) co_return unplugged();
    in_control = false;
    co_return {};
  }
  Task<Result<void>> start_move(std::vector<arm::Joints> waypoints, double speed) override {
    if (!plugged) co_return unplugged();
    if (!in_control) co_return uncontrolled();
    if (moving()) co_return fail("busy", "the controller is in a move");
    for (const arm::Joints& joints : waypoints) {
      const Result<void> within = arm::check_limits(model_, joints);
      if (!within) co_return within;
    }
    ++moves;
    last_waypoints = waypoints;
    last_speed = speed;
    stopped_ = false;
    path_ = {path_.back()};
    path_.insert(path_.end(), waypoints.begin(), waypoints.end());
    begun_ = executor_.now();
    co_return {};
  }
  Task<Result<void>> stop() override {
    if (!plugged) co_return unplugged();
    stopped_ = moving();
    path_ = {at()};
    co_return {};
  }
  Task<Result<void>> start_gripper(double opening_mm) override {
    if (!plugged) co_return unplugged();
    if (!in_control) co_return uncontrolled();
    opening_ = opening();
    towards_ = std::max(opening_mm, between_fingers_mm);
    squeezed_ = executor_.now();
    co_return {};
  }
  Task<Result<arm::ArmReading>> read() override {
    if (!plugged) co_return unplugged();
    arm::ArmReading reading{at(), moving(), stopped_, opening(), opening() != towards_};
    reading.trouble = trouble;
    reading.gripped = gripped;
    hear_state();
    co_return reading;
  }

  double opening() const {
    const double way = 100 * seconds_since(squeezed_);
    return towards_ > opening_ ? std::min(towards_, opening_ + way) : std::max(towards_, opening_ - way);
  }

 private:
  static std::unexpected<Failure> unplugged() { return fail("disconnected", "the plug is pulled"); }
  static std::unexpected<Failure> uncontrolled() { return fail("not-in-control", "the pendant has control"); }
  double seconds_since(Time then) const { return std::chrono::duration<double>(executor_.now() - then).count(); }
  double leg_seconds(std::size_t leg) const {
    double slowest = 0;
    for (std::size_t axis = 0; axis < model_.axes.size(); ++axis) {
      const double speed = model_.axes[axis].speed * last_speed;
      slowest = std::max(slowest, std::abs(path_[leg + 1][axis] - path_[leg][axis]) / speed);
    }
    return slowest;
  }

  std::vector<arm::Joints> path_;
  Time begun_{};
  bool stopped_ = false;
  double opening_ = 80;
  double towards_ = 80;
  Time squeezed_{};
};

}  // namespace pizarra::robot
