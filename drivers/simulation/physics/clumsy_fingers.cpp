#include "drivers/simulation/physics/clumsy_fingers.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pizarra::simulation {

namespace {

// Parts of the way that are tried where another cube stands in it.
constexpr int tries = 20;
// A cube at the height of another, as a part of the edge, would stand in it.
constexpr double same_height = 0.9;

}  // namespace

void ClumsyFingers::begin_carry() {
  slip_after_s_.clear();
  for (int draw = 0; draw < slips_.draws; ++draw) {
    const bool slips = random_.uniform(0, 1) < slips_.chance;
    const double after_s = random_.uniform(0, slips_.within_s);
    if (slips) slip_after_s_.push_back(after_s);
  }
}

void ClumsyFingers::step(double seconds) {
  const std::optional<DynamicId> held = gripper_.held();
  if (held != carried_) {
    const bool put_down = carried_ && !held && gripper_.opens() && physics_.present(*carried_);
    if (put_down && misplaces_ > 0) put_off(*carried_);
    slip_after_s_.clear();
    if (held) begin_carry();
    carried_ = held;
    return;
  }
  for (double& after_s : slip_after_s_) after_s -= seconds;
  const bool slips = std::ranges::any_of(slip_after_s_, [](double after_s) { return after_s <= 0; });
  if (!slips) return;
  gripper_.slip();
  slip_after_s_.clear();
  carried_.reset();
}

bool ClumsyFingers::is_free(DynamicId cube, const Eigen::Vector3d& at) const {
  for (DynamicId other = 0; other < physics_.dynamics(); ++other) {
    if (other == cube || !physics_.present(other)) continue;
    const double edge = (physics_.width_mm(cube) + physics_.width_mm(other)) / 2;
    const Eigen::Vector3d apart = (physics_.pose(other).translation() - at).cwiseAbs();
    if (apart.z() < same_height * edge && apart.head<2>().norm() < edge) return false;
  }
  return true;
}

// As far as there is room: a cube that meets another stops there.
void ClumsyFingers::put_off(DynamicId cube) {
  const double direction = random_.uniform(0, 2 * std::numbers::pi);
  const double far_mm = random_.uniform(0, misplaces_) * physics_.width_mm(cube);
  const Pose from = physics_.pose(cube);
  for (int part = tries; part > 0; --part) {
    const double aside_mm = far_mm * part / tries;
    Pose to = from;
    to.translation() += aside_mm * Eigen::Vector3d(std::cos(direction), std::sin(direction), 0);
    if (!is_free(cube, to.translation())) continue;
    gripper_.let_pass(cube);
    physics_.bring(cube, to);
    return;
  }
}

}  // namespace pizarra::simulation
