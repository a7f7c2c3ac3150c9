#include "drivers/simulation/physics/hand.hpp"

#include <algorithm>
#include <cmath>

#include "lisp/numbers.hpp"

namespace pizarra::simulation {

namespace {

using Eigen::Vector3d;

constexpr double push_s = 0.5;
constexpr double push_speed_mm_s = 400;   // a longer push takes longer
constexpr double carry_speed_mm_s = 500;  // mean over a leg
constexpr double lower_speed_mm_s = 150;
constexpr double strike_speed_mm_s = 320;
constexpr double clearance_mm = 50;  // above what may stand in a carried cube's way
constexpr double drop_mm = 0.5;      // a cube is let go that little above its place
constexpr double slip_mm = 45;       // a cube that lags this far is out of the hand
constexpr double lead_limit_mm_s = 1500;
constexpr double straighten_s = 0.12;
constexpr double straighten_limit_rad_s = 6;
constexpr double turn_s = 1;
constexpr double strike_run_up_mm = 140;
constexpr double strike_through_mm = 60;
const Vector3d fist_half_mm(26, 26, 26);
constexpr double settle_s = 0.4;
constexpr double gravity_mm_s2 = 9810;

// From 0 to 1 with zero speed at both ends.
double smooth(double part) { return part * part * (3 - 2 * part); }

// The nearest pose in which the cube stands square on the table.
Eigen::Matrix3d straightened(const Eigen::Matrix3d& rotation) {
  // Each axis of the cube goes to the base axis it is nearest; the third follows from the first two.
  Eigen::Matrix3d straight = Eigen::Matrix3d::Zero();
  int taken = -1;
  for (const int column : {2, 0}) {
    int best = taken == 0 ? 1 : 0;
    for (int row = 0; row < 3; ++row) {
      if (row != taken && std::abs(rotation(row, column)) > std::abs(rotation(best, column))) best = row;
    }
    straight(best, column) = rotation(best, column) < 0 ? -1 : 1;
    taken = best;
  }
  straight.col(1) = straight.col(2).cross(straight.col(0));
  return straight;
}

// Axis times angle.
Vector3d turn_between(const Eigen::Matrix3d& from, const Eigen::Matrix3d& to) {
  const Eigen::AngleAxisd turn(to * from.transpose());
  return turn.axis() * turn.angle();
}

}  // namespace

Hand::Hand(Physics& physics, Gripper& gripper)
    : physics_(physics), gripper_(gripper), fist_(physics.add_kinematic({{Vector3d::Zero(), fist_half_mm}}, 0.5)) {
  physics_.enable_kinematic(fist_, false);
}

Result<void> Hand::begin(Job job, std::optional<DynamicId> cube, const Vector3d& from_mm) {
  if (busy()) return fail("busy", "the hand is doing something else");
  if (cube && gripper_.held() == cube && job == Job::carry) gripper_.lose();
  job_ = job;
  cube_ = cube.value_or(0);
  takes_away_ = false;
  turned_.reset();
  from_mm_ = from_mm;
  legs_.clear();
  leg_ = 0;
  leg_time_s_ = 0;
  return {};
}

void Hand::add_leg(const Vector3d& to_mm, double speed_mm_s) {
  const Vector3d from = legs_.empty() ? from_mm_ : legs_.back().to_mm;
  legs_.push_back({to_mm, std::max(0.15, (to_mm - from).norm() / speed_mm_s)});
}

Result<void> Hand::push(DynamicId cube, double dx_mm, double dy_mm) {
  const Vector3d from = physics_.pose(cube).translation();
  Result<void> begun = begin(Job::slide, cube, from);
  if (!begun) return begun;
  legs_.push_back({from + Vector3d(dx_mm, dy_mm, 0), std::max(push_s, std::hypot(dx_mm, dy_mm) / push_speed_mm_s)});
  return {};
}

Result<void> Hand::slide(DynamicId cube, double dx_mm, double dy_mm, double speed_mm_s) {
  const Vector3d from = physics_.pose(cube).translation();
  Result<void> begun = begin(Job::slide, cube, from);
  if (!begun) return begun;
  legs_.push_back({from + Vector3d(dx_mm, dy_mm, 0), std::hypot(dx_mm, dy_mm) / speed_mm_s, true});
  return {};
}

double Hand::carry_height(DynamicId cube) const {
  double highest = 0;
  for (DynamicId other = 0; other < physics_.dynamics(); ++other) {
    if (other == cube || !physics_.present(other) || gripper_.held() == other) continue;
    highest = std::max(highest, physics_.pose(other).translation().z());
  }
  return highest + physics_.height_mm(cube) + clearance_mm;
}

double Hand::support_height(DynamicId cube, double x_mm, double y_mm) const {
  double top = 0;
  for (DynamicId other = 0; other < physics_.dynamics(); ++other) {
    if (other == cube || !physics_.present(other) || gripper_.held() == other) continue;
    const Vector3d place = physics_.pose(other).translation();
    const double aside = std::max(std::abs(place.x() - x_mm), std::abs(place.y() - y_mm));
    const double touching_mm = (physics_.width_mm(cube) + physics_.width_mm(other)) / 2;
    if (aside < touching_mm) top = std::max(top, place.z() + physics_.height_mm(other) / 2);
  }
  return top;
}

void Hand::put_down(DynamicId cube, const Vector3d& on_mm) {
  const double height = std::max(carry_height(cube), from_mm_.z());
  add_leg({from_mm_.x(), from_mm_.y(), height}, carry_speed_mm_s);
  add_leg({on_mm.x(), on_mm.y(), height}, carry_speed_mm_s);
  const Vector3d above = on_mm + Vector3d(0, 0, 20);
  if (height > above.z()) add_leg(above, carry_speed_mm_s);
  add_leg(on_mm, lower_speed_mm_s);
}

Result<void> Hand::place(DynamicId cube, double x_mm, double y_mm) {
  Result<void> begun = begin(Job::carry, cube, physics_.pose(cube).translation());
  if (!begun) return begun;
  put_down(cube, {x_mm, y_mm, support_height(cube, x_mm, y_mm) + physics_.height_mm(cube) / 2 + drop_mm});
  return {};
}

Result<void> Hand::stack(DynamicId cube, DynamicId on) {
  if (cube == on) return fail("bad-request", "a cube cannot stand on itself");
  const Vector3d below = physics_.pose(on).translation();
  return place(cube, below.x(), below.y());
}

Result<void> Hand::hold(DynamicId cube, const Vector3d& at_mm, double seconds) {
  const Vector3d from = physics_.pose(cube).translation();
  Result<void> begun = begin(Job::carry, cube, from);
  if (!begun) return begun;
  const Vector3d above(from.x(), from.y(), std::max(carry_height(cube), at_mm.z()));
  add_leg(above, carry_speed_mm_s);
  add_leg(at_mm, carry_speed_mm_s);
  legs_.push_back({at_mm, seconds});
  add_leg(above, carry_speed_mm_s);
  const double support = support_height(cube, from.x(), from.y());
  add_leg({from.x(), from.y(), support + physics_.height_mm(cube) / 2 + drop_mm}, lower_speed_mm_s);
  return {};
}

Result<void> Hand::turn(DynamicId cube, double anticlockwise_deg) {
  const Pose pose = physics_.pose(cube);
  const Vector3d from = pose.translation();
  Result<void> begun = begin(Job::carry, cube, from);
  if (!begun) return begun;
  const Vector3d above(from.x(), from.y(), std::max(carry_height(cube), from.z()));
  add_leg(above, carry_speed_mm_s);
  legs_.push_back({above, turn_s});
  const double support = support_height(cube, from.x(), from.y());
  add_leg({from.x(), from.y(), support + physics_.height_mm(cube) / 2 + drop_mm}, lower_speed_mm_s);
  turned_ = Eigen::AngleAxisd(radians(anticlockwise_deg), Vector3d::UnitZ()) * straightened(pose.linear());
  return {};
}

Result<void> Hand::steal(DynamicId cube) {
  const Vector3d from = physics_.pose(cube).translation();
  Result<void> begun = begin(Job::carry, cube, from);
  if (!begun) return begun;
  const Vector3d out = from + Vector3d(160, 0, 5);
  add_leg(out, carry_speed_mm_s);
  add_leg(out + Vector3d(250, 0, 250), 1.6 * carry_speed_mm_s);
  takes_away_ = true;
  return {};
}

Result<void> Hand::remove(DynamicId cube) {
  const Vector3d from = physics_.pose(cube).translation();
  Result<void> begun = begin(Job::carry, cube, from);
  if (!begun) return begun;
  const Vector3d up(from.x(), from.y(), std::max(carry_height(cube), from.z()));
  add_leg(up, carry_speed_mm_s);
  add_leg(up + Vector3d(300, 0, 250), 1.6 * carry_speed_mm_s);
  takes_away_ = true;
  return {};
}

Result<void> Hand::add(DynamicId cube, double x_mm, double y_mm) {
  const Vector3d from(x_mm + 150, y_mm, carry_height(cube));
  const Vector3d half = Vector3d(physics_.width_mm(cube), physics_.width_mm(cube), physics_.height_mm(cube)) / 2;
  const bool in_the_way = gripper_.stands_over({x_mm, y_mm, from.z()}, half);
  if (in_the_way) return fail("busy", "the gripper is where the hand is to put it");
  Result<void> begun = begin(Job::carry, cube, from);
  if (!begun) return begun;
  Pose pose = Pose::Identity();
  pose.translation() = from;
  physics_.bring(cube, pose);
  put_down(cube, {x_mm, y_mm, support_height(cube, x_mm, y_mm) + physics_.height_mm(cube) / 2 + drop_mm});
  return {};
}

bool Hand::run_up_is_free(DynamicId struck, const Vector3d& start_mm) const {
  for (DynamicId other = 0; other < physics_.dynamics(); ++other) {
    if (other == struck || !physics_.present(other)) continue;
    if ((physics_.pose(other).translation() - start_mm).norm() < physics_.width_mm(other) / 2 + 2 * fist_half_mm.x())
      return false;
  }
  return true;
}

Result<void> Hand::knock(DynamicId cube) {
  const Vector3d at = physics_.pose(cube).translation();
  // From outside, so that it falls towards the table's middle; from inside where something is in the run-up's way.
  const double outside = at.y() < 0 ? -1 : 1;
  const double side = run_up_is_free(cube, at + Vector3d(0, outside * strike_run_up_mm, 0)) ? outside : -outside;
  const double height = std::max(at.z(), fist_half_mm.z() + 1);
  const Vector3d start(at.x(), at.y() + side * strike_run_up_mm, height);
  Result<void> begun = begin(Job::strike, std::nullopt, start);
  if (!begun) return begun;
  const Vector3d through(at.x(), at.y() - side * strike_through_mm, height);
  add_leg(through, strike_speed_mm_s);
  add_leg(start + Vector3d(0, 0, 250), strike_speed_mm_s);
  physics_.enable_kinematic(fist_, true);
  return {};
}

Vector3d Hand::wanted(double seconds_from_now) const {
  const Leg& leg = legs_[leg_];
  const Vector3d from = leg_ == 0 ? from_mm_ : legs_[leg_ - 1].to_mm;
  const double part = std::clamp((leg_time_s_ + seconds_from_now) / leg.seconds, 0.0, 1.0);
  return from + (leg.to_mm - from) * (leg.even ? part : smooth(part));
}

void Hand::lead(double seconds) {
  const Pose pose = physics_.pose(cube_);
  const Vector3d at = pose.translation();
  Vector3d lag = wanted(0) - at;
  if (job_ == Job::slide) lag.z() = 0;
  if (lag.norm() > slip_mm) {
    takes_away_ = false;
    return end();
  }
  Vector3d velocity = (wanted(seconds) - at) / seconds;
  if (velocity.norm() > lead_limit_mm_s) velocity *= lead_limit_mm_s / velocity.norm();
  if (job_ == Job::slide) {
    velocity.z() = physics_.velocity_mm_s(cube_).z();
    const Vector3d spin = physics_.spin_rad_s(cube_);
    physics_.set_velocity(cube_, velocity, {spin.x(), spin.y(), 0});
    const Vector3d ahead = (legs_[0].to_mm - from_mm_).normalized();
    fist_seen_ = at + Vector3d(-10, 0, 0) - ahead * (physics_.width_mm(cube_) / 2 + 1.2 * fist_half_mm.x());
    return;
  }
  velocity.z() += gravity_mm_s2 * seconds;  // what the step is about to take away
  const bool is_turned = turned_ && leg_ > 0;
  Vector3d spin = turn_between(pose.linear(), is_turned ? *turned_ : straightened(pose.linear())) / straighten_s;
  if (spin.norm() > straighten_limit_rad_s) spin *= straighten_limit_rad_s / spin.norm();
  physics_.set_velocity(cube_, velocity, spin);
  fist_seen_ = at + Vector3d(-15, 0, physics_.height_mm(cube_) / 2 + 0.8 * fist_half_mm.z());
}

void Hand::watch(double seconds) {
  leg_time_s_ += seconds;
  if (leg_time_s_ >= settle_s) job_ = Job::none;
}

void Hand::step(double seconds) {
  if (!busy()) return;
  if (job_ == Job::watch) return watch(seconds);
  if (job_ == Job::strike) {
    Pose pose = Pose::Identity();
    pose.translation() = wanted(0);
    physics_.move_kinematic(fist_, pose);
    fist_seen_ = pose.translation();
  } else {
    if (!physics_.present(cube_)) return end();
    lead(seconds);
    if (job_ == Job::watch) return;
  }
  leg_time_s_ += seconds;
  if (leg_time_s_ < legs_[leg_].seconds) return;
  leg_time_s_ = 0;
  if (++leg_ == legs_.size()) end();
}

void Hand::end() {
  if (job_ == Job::strike) {
    physics_.enable_kinematic(fist_, false);
  } else if (physics_.present(cube_)) {
    physics_.set_velocity(cube_, Vector3d::Zero(), Vector3d::Zero());
    if (takes_away_) physics_.take_away(cube_);
  }
  job_ = Job::watch;
  leg_time_s_ = 0;
  fist_seen_.reset();
}

std::optional<DynamicId> Hand::carried() const {
  if (job_ == Job::carry || job_ == Job::slide) return cube_;
  return std::nullopt;
}

}  // namespace pizarra::simulation
