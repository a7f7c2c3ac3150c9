// What is measured in a look, and what is perceived from it.

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "agents/coordinator/perceive/surroundings.hpp"

namespace pizarra::coordinator {

namespace {

// A look under way when the arm came to rest may show it moving; the second after it does not.
constexpr std::uint64_t looks_till_rest = 2;
// The eyes and an arm that differ by more do not see the same mark.
constexpr double most_off_mm = 30;

}  // namespace

void Surroundings::compare_pose() {
  const bool rests = looks() >= pose_look_ + looks_till_rest;
  if (!pose_mm_ || !rests || !sightings_.recent(options_.gripper.mark, 1)) return;
  const Eigen::Vector3d said = *pose_mm_ - domain_.cube_mm() / 2 * view_->away();
  const Eigen::Vector3d off = *grip_mm() - said;
  if (off.norm() < most_off_mm) pose_off_mm_ = off;
}

void Surroundings::excuse_hidden() {
  const std::optional<Eigen::Vector3d> grip = grip_mm();
  if (!grip) return;
  std::vector<std::string> hidden;
  for (const auto& [name, sighting] : sightings_.all()) {
    const bool unseen = name != options_.gripper.mark && !sightings_.recent(name, 1);
    if (unseen && hidden_by_gripper(*view_, options_.gripper.outline, *grip, sighting.place_mm)) hidden.push_back(name);
  }
  for (const std::string& name : hidden) sightings_.excuse(name);
}

Eigen::Vector3d Surroundings::mark_to_front_mm() const {
  const double behind_mm = options_.gripper.mark_before_grip_mm - domain_.cube_mm() / 2;
  return behind_mm * view_->away() - options_.gripper.mark_above_grip_mm * Eigen::Vector3d::UnitZ();
}

std::optional<Eigen::Vector3d> Surroundings::grip_mm() const {
  if (view_ && sightings_.recent(options_.gripper.mark, 1)) {
    const Eigen::Vector3d& mark = sightings_.find(options_.gripper.mark)->place_mm;
    return Eigen::Vector3d(mark + mark_to_front_mm());
  }
  if (!pose_mm_ || !view_) return std::nullopt;
  return Eigen::Vector3d(*pose_mm_ - domain_.cube_mm() / 2 * view_->away() + pose_off_mm_);
}

// The mark stands before the middle in the direction in which its face looks.
Eigen::Vector3d Surroundings::centre_mm(const std::string& name, const Sighting& sighting) const {
  if (!view_) return sighting.place_mm;
  const double yaw = sightings_.yaw_deg(name) * std::numbers::pi / 180;
  const Eigen::Vector3d looks = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) * -view_->away();
  return sighting.place_mm - domain_.cube_mm() / 2 * looks;
}

std::optional<std::string> Surroundings::foremost() const {
  if (!view_) return std::nullopt;
  const Eigen::Vector3d row(options_.row.x_mm, 0, 0);
  double nearest_mm = 0.7 * domain_.cube_mm();
  std::optional<std::string> foremost;
  for (const auto& [name, sighting] : sightings_.all()) {
    if (name == options_.gripper.mark || !sightings_.recent(name, 1)) continue;
    const double before_mm = -(centre_mm(name, sighting) - row).dot(view_->away());
    if (before_mm <= nearest_mm) continue;
    nearest_mm = before_mm;
    foremost = name;
  }
  return foremost;
}

std::optional<std::string> Surroundings::may_hide(const std::string& missing) const {
  const Sighting* last = sightings_.find(missing);
  if (!last || !view_) return foremost();
  const Eigen::Vector3d place = centre_mm(missing, *last);
  double least_aside_mm = 1.5 * domain_.cube_mm();
  std::optional<std::string> nearest;
  for (const auto& [name, sighting] : sightings_.all()) {
    if (name == options_.gripper.mark || name == missing || !sightings_.recent(name, 1)) continue;
    const Eigen::Vector3d apart = centre_mm(name, sighting) - place;
    const double aside_mm = std::abs(apart.dot(view_->right()));
    if (-apart.dot(view_->away()) < domain_.cube_mm() / 2 || aside_mm >= least_aside_mm) continue;
    least_aside_mm = aside_mm;
    nearest = name;
  }
  return nearest ? nearest : foremost();
}

std::vector<Datum> Surroundings::measure() const {
  std::vector<Datum> measured;
  if (opening_mm_) measured.push_back(list("gripper"_sym, *opening_mm_));
  const std::optional<Eigen::Vector3d> grip = grip_mm();
  if (grip) measured.push_back(list("grip"_sym, grip->x(), grip->y(), grip->z()));
  for (const auto& [name, sighting] : sightings_.all()) {
    if (name == options_.gripper.mark || !sightings_.recent(name, grace_)) continue;
    const Eigen::Vector3d& at = sighting.place_mm;
    measured.push_back(list("seen"_sym, Datum::symbol(name), at.x(), at.y(), at.z()));
    if (!sightings_.recent(name, 1)) measured.push_back(list("unseen"_sym, Datum::symbol(name)));
  }
  return measured;
}

Result<Facts> Surroundings::perceive() const {
  const std::vector<Datum> believed(beliefs().begin(), beliefs().end());
  const Result<std::vector<Datum>> found = domain_.perception().perceive(measure(), believed);
  if (!found) return fail(found);
  Facts facts;
  for (const Datum& fact : *found) {
    if (domain_.domain().find_predicate(fact.head())) facts.insert(fact);
  }
  return facts;
}

}  // namespace pizarra::coordinator
