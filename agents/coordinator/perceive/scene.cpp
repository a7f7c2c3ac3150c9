#include "agents/coordinator/perceive/scene.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace pizarra::coordinator {

namespace {

// For how many looks an object must lie where it is to count as still.
constexpr std::uint64_t still_looks = 5;
// From the picture to the reply at most so many frames pass: so many looks after the head has come to rest may be
// older.
constexpr int looks_on_their_way = 3;
// A mark that is nearer to the place of a held object goes with the arm.
constexpr double held_mm = 40;
// A look under way when the arm came to rest may show it moving; the second after it does not.
constexpr std::uint64_t looks_till_rest = 2;
// The eyes and an arm that differ by more do not see the same mark, or the camera was knocked. Then two places of the
// tool tell of one difference: of an image that stands still they tell of two.
constexpr double most_off_mm = 30;
constexpr double most_off_knocked_mm = 80;  // 30 mm and 3 degrees, a metre away
constexpr double elsewhere_mm = 5;
constexpr double one_difference_mm = 8;
// The middle of what hangs in the air is at least so many cubes above the table: higher than on a cube that is not
// seen.
constexpr double hanging_cubes = 1.75;
// From the middle of a cube to that of one which it rests or leans on, at most, in cubes.
constexpr double leaning_cubes = 1.6;

// A smaller turn of a cube is straightened by the fingers; a larger one hides the end effector's mark.
constexpr double least_turn_deg = 4;
constexpr double most_turn_deg = 38;

Datum as_list(const Eigen::Vector3d& at) { return list(at.x(), at.y(), at.z()); }

}  // namespace

Scene::Scene(const CoordinatorOptions& options, const TaskDomain& domain)
    : options_(options), domain_(domain), camera_(options.camera, options.row) {
  if (!options_.head) head_ = HeadTurn();
}

void Scene::take_camera(const CameraModel& model) {
  model_ = model;
  turn_view();
}

// The offset of the arm's word was measured with that camera. The view stays, for an operation under way.
void Scene::forget_camera() {
  model_.reset();
  pose_off_mm_ = Eigen::Vector3d::Zero();
}

void Scene::take_head(std::optional<HeadTurn> turn) {
  head_ = turn;
  if (!head_) return;
  blurred_looks_ = looks_on_their_way;
  turn_view();
}

void Scene::turn_view() {
  if (model_ && head_) view_.emplace(camera_.pose(), *model_, *head_);
}

void Scene::take_pose(const Eigen::Isometry3d& tool) {
  tool_ = tool;
  pose_look_ = sightings_.looks();
}

std::optional<double> Scene::tool_yaw_deg() const {
  if (!tool_) return std::nullopt;
  return std::atan2(tool_->linear()(1, 0), tool_->linear()(0, 0)) * 180 / std::numbers::pi;
}

void Scene::take_arm(bool rests) {
  rests_ = rests;
  pose_look_ = sightings_.looks();
}

void Scene::take_camera_pose(const CameraMeasured& measured) {
  camera_.go_on_from(measured);
  turn_view();
}

bool Scene::places_next_look() {
  if (!model_ || !head_) return false;
  if (blurred_looks_ == 0) return true;
  --blurred_looks_;
  return false;
}

forms::LookSituation Scene::situation() const {
  forms::LookSituation out;
  out.camera = view_->numbers();
  const std::optional<Eigen::Vector3d> by_arm = grip_by_arm_mm();
  const GripperOutline& outline = options_.gripper.outline;
  out.hand = list(options_.gripper.mark, as_list(mark_to_front_mm()), by_arm ? as_list(*by_arm) : Datum(),
                  outline.half_width_mm, outline.below_mm, outline.mark_half_mm);
  for (const auto& [name, sighting] : sightings_.all()) {
    if (!sightings_.remembered(name, options_.grace_looks)) continue;
    const std::uint64_t age = sightings_.looks() + 1 - sighting.look;
    // A held object went with the gripper: it is not hidden where it was seen last.
    const bool excusable = !sighting.in_gripper && sighting.excused < Sightings::most_excused;
    out.remembered.push_back(list(name, as_list(sighting.place_mm), age, excusable ? 1 : 0));
  }
  if (opening_mm_) out.measured.push_back(list("gripper"_sym, *opening_mm_));
  return out;
}

CameraWatch::News Scene::take_look(std::int64_t frame, const forms::PerceivedLook& look, bool captured_at_rest) {
  sightings_.look(frame, look.seen, head_->pan_deg);
  for (const std::string& name : look.hidden) sightings_.excuse(name);
  note_held(look.seen);
  carry_held();
  note_covered(look.hidden);
  const bool shows_rest = tool_ && rests_ && (captured_at_rest || is_late_enough());
  if (!shows_rest || !sightings_.recent(options_.gripper.mark, 1)) return CameraWatch::News::nothing;
  compare_pose();
  return watch_camera();
}

bool Scene::fingers_hold() const { return opening_mm_ && domain_.edge_like(*opening_mm_); }

void Scene::note_held(std::span<const forms::SeenObject> seen) {
  const std::optional<Eigen::Vector3d> grip = grip_mm();
  if (!grip || !fingers_hold()) return;
  for (const forms::SeenObject& object : seen) {
    if (object.name == options_.gripper.mark) continue;
    const Eigen::Vector3d place(object.at_mm[0], object.at_mm[1], object.at_mm[2]);
    if ((place - *grip).norm() < held_mm) sightings_.hold(object.name);
  }
}

// The gripper carries a held object on where the images' border cuts it off.
void Scene::carry_held() {
  const std::optional<Eigen::Vector3d> grip = grip_by_arm_mm();
  if (!grip || !fingers_hold() || view_->shows(*grip, options_.gripper.outline.mark_half_mm)) return;
  for (const auto& [name, sighting] : sightings_.all()) {
    if (sighting.in_gripper) sightings_.carry(name, *grip + set_back_mm(name));
  }
}

// A cube that another stands before does not show, and is not gone for that.
void Scene::note_covered(std::span<const std::string> hidden_by_gripper) {
  const SightLines lines = sight_lines(0);
  for (const auto& [name, hidden] : sightings_.all()) {
    if (hidden.in_gripper || name == options_.gripper.mark || sightings_.recent(name, 1)) continue;
    if (std::ranges::find(hidden_by_gripper, name) != hidden_by_gripper.end()) continue;
    const Eigen::Vector3d middle = centre_mm(name, hidden);
    const bool is_covered = std::ranges::any_of(sightings_.all(), [&](const auto& other) {
      const bool stands = other.first != options_.gripper.mark && sightings_.recent(other.first, 1);
      return stands && lines.covers(centre_mm(other.first, other.second), middle);
    });
    if (is_covered) sightings_.cover(name);
  }
}

SightLines Scene::sight_lines(double margin_mm) const {
  const auto eyes = view_->eyes();
  return {.eyes_mm = {eyes.begin(), eyes.end()},
          .cube_mm = domain_.cube_mm(),
          .mark_half_mm = options_.gripper.outline.mark_half_mm,
          .margin_mm = margin_mm};
}

bool Scene::is_late_enough() const {
  return sightings_.looks() >= pose_look_ + looks_till_rest &&
         sightings_.still_looks(options_.gripper.mark) >= looks_till_rest;
}

// The look was placed by the view that is taken back here.
CameraWatch::News Scene::watch_camera() {
  const Eigen::Vector3d& placed = sightings_.find(options_.gripper.mark)->place_mm;
  const CameraWatch::News news = camera_.take({*tool_, *head_, seen_mark(*view_, placed)}, *model_);
  using News = CameraWatch::News;
  const bool placed_anew = news == News::found || news == News::corrected || news == News::moved;
  if (placed_anew) {
    turn_view();
    pose_off_mm_ = Eigen::Vector3d::Zero();
    compared_.reset();
  }
  return news;
}

void Scene::compare_pose() {
  const Eigen::Vector3d off = *grip_mm() - held_front_by_arm_mm();
  const Eigen::Vector3d tool = tool_->translation();
  const bool is_elsewhere = !compared_ || (tool - compared_->tool_mm).norm() > elsewhere_mm;
  const bool is_one_difference = compared_ && is_elsewhere && (off - compared_->off_mm).norm() < one_difference_mm;
  if (off.norm() < (is_one_difference ? most_off_knocked_mm : most_off_mm)) pose_off_mm_ = off;
  if (is_elsewhere) compared_ = Compared{tool, off};
}

// The front of what is held looks as the fingers do.
Eigen::Vector3d Scene::held_front_by_arm_mm() const {
  return tool_->translation() + domain_.cube_mm() / 2 * fingers_look();
}

Eigen::Vector3d Scene::mark_to_front_mm() const {
  const double behind_mm = options_.gripper.mark_before_grip_mm - domain_.cube_mm() / 2;
  return behind_mm * view_->away() - options_.gripper.mark_above_grip_mm * Eigen::Vector3d::UnitZ();
}

std::optional<Eigen::Vector3d> Scene::grip_by_arm_mm() const {
  if (!tool_ || !view_) return std::nullopt;
  return Eigen::Vector3d(held_front_by_arm_mm() + pose_off_mm_);
}

std::optional<Eigen::Vector3d> Scene::grip_mm() const {
  if (!view_ || !sightings_.recent(options_.gripper.mark, 1)) return grip_by_arm_mm();
  const Eigen::Vector3d& mark = sightings_.find(options_.gripper.mark)->place_mm;
  return Eigen::Vector3d(mark + mark_to_front_mm());
}

bool Scene::mark_in_view() const {
  const std::optional<Eigen::Vector3d> grip = grip_by_arm_mm();
  return !grip || view_->shows(*grip - mark_to_front_mm(), options_.gripper.outline.mark_half_mm);
}

Eigen::Vector3d Scene::set_back_mm(std::string_view name) const {
  return (domain_.cube_mm() - domain_.edge_mm(name)) / 2 * view_->away();
}

// The base frame's x axis looks at a camera that faces the arm.
double Scene::fingers_deg(std::string_view name) const {
  const double seen_deg = sightings_.face_deg(name).value_or(0);
  const double wanted_deg =
      std::abs(seen_deg) < least_turn_deg ? 0 : std::clamp(seen_deg, -most_turn_deg, most_turn_deg);
  return wanted_deg - camera_.pose().pan_deg;
}

Eigen::Vector3d Scene::looks_towards(double yaw_deg) const {
  return Eigen::AngleAxisd(yaw_deg * std::numbers::pi / 180, Eigen::Vector3d::UnitZ()) * -view_->away();
}

Eigen::Vector3d Scene::fingers_look() const { return looks_towards(*tool_yaw_deg() + camera_.pose().pan_deg); }

// The mark stands before the middle in the direction in which its face looks.
Eigen::Vector3d Scene::centre_mm(const std::string& name, const Sighting& sighting) const {
  if (!view_) return sighting.place_mm;
  const double yaw_deg = sightings_.face_deg(name).value_or(0);
  return sighting.place_mm - domain_.edge_mm(name) / 2 * looks_towards(yaw_deg);
}

Eigen::Vector3d Scene::face_to_fingers_mm(const std::string& name) const {
  const std::optional<double> face_deg = sightings_.face_deg(name);
  if (!view_ || !face_deg || !tool_) return Eigen::Vector3d::Zero();
  return domain_.edge_mm(name) / 2 * (fingers_look() - looks_towards(*face_deg));
}

std::optional<std::string> Scene::foremost(const std::set<std::string>& but) const {
  if (!view_) return std::nullopt;
  const Eigen::Vector3d row(options_.row.x_mm, 0, 0);
  double nearest_mm = 0.7 * domain_.cube_mm();
  std::optional<std::string> foremost;
  for (const auto& [name, sighting] : sightings_.all()) {
    if (name == options_.gripper.mark || but.contains(name) || !sightings_.recent(name, 1)) continue;
    const double before_mm = -(centre_mm(name, sighting) - row).dot(view_->away());
    if (before_mm <= nearest_mm) continue;
    nearest_mm = before_mm;
    foremost = name;
  }
  return foremost;
}

// A cube that falls off a pile comes to lie within three of its edges.
double Scene::falls_within_mm(const Sighting& last) const { return 3 * domain_.cube_mm() + last.place_mm.z(); }

// Behind a cube that stands alone, one that was not seen in any life is not looked for: it is more likely to be away.
std::optional<std::string> Scene::nearest_to(const std::string& missing, const std::set<std::string>& but,
                                             bool was_here) const {
  const Sighting* last = sightings_.find(missing);
  double least_mm = std::numeric_limits<double>::infinity();
  std::optional<std::string> nearest;
  for (const auto& [name, sighting] : sightings_.all()) {
    const bool other = name != options_.gripper.mark && name != missing && !but.contains(name);
    if (!other || !sightings_.recent(name, 1) || (!last && !was_here && top_of_pile(name) == name)) continue;
    const double apart_mm =
        last ? (centre_mm(name, sighting) - centre_mm(missing, *last)).head<2>().norm() : -sighting.place_mm.x();
    const bool too_far = last && apart_mm > falls_within_mm(*last);
    if (too_far || apart_mm >= least_mm) continue;
    least_mm = apart_mm;
    nearest = name;
  }
  return nearest;
}

std::string Scene::top_of_pile(std::string name) const {
  const Eigen::Vector3d below = centre_mm(name, *sightings_.find(name));
  double highest_mm = below.z();
  std::string top = std::move(name);
  for (const auto& [other, sighting] : sightings_.all()) {
    if (other == options_.gripper.mark || !sightings_.recent(other, 1)) continue;
    const Eigen::Vector3d at = centre_mm(other, sighting);
    const bool of_pile = (at - below).head<2>().norm() < domain_.cube_mm();
    if (!of_pile || at.z() <= highest_mm) continue;
    highest_mm = at.z();
    top = other;
  }
  return top;
}

std::optional<std::string> Scene::stands_before(const std::string& missing, const std::set<std::string>& but) const {
  const Sighting* last = sightings_.find(missing);
  if (!last || !view_) return std::nullopt;
  const Eigen::Vector3d place = centre_mm(missing, *last);
  std::optional<std::string> hides;
  double least_aside_mm = 1.5 * domain_.cube_mm();
  for (const auto& [name, sighting] : sightings_.all()) {
    const bool other = name != options_.gripper.mark && name != missing && !but.contains(name);
    if (!other || !sightings_.recent(name, 1)) continue;
    const Eigen::Vector3d apart = centre_mm(name, sighting) - place;
    const double aside_mm = std::abs(apart.dot(view_->right()));
    if (-apart.dot(view_->away()) < domain_.cube_mm() / 2 || aside_mm >= least_aside_mm) continue;
    least_aside_mm = aside_mm;
    hides = name;
  }
  return hides ? std::optional(top_of_pile(*hides)) : std::nullopt;
}

std::optional<std::string> Scene::may_hide(const std::string& missing, const std::set<std::string>& but,
                                           bool was_here) const {
  std::optional<std::string> before = stands_before(missing, but);
  if (before) return before;
  std::optional<std::string> hides = foremost(but);
  if (!hides) hides = nearest_to(missing, but, was_here);
  return hides ? std::optional(top_of_pile(*hides)) : std::nullopt;
}

std::optional<std::string> Scene::neighbour_of(const std::string& name) const {
  const std::optional<std::string> nearest = nearest_to(name, {}, true);
  return nearest ? std::optional(top_of_pile(*nearest)) : std::nullopt;
}

std::optional<std::string> Scene::under(const std::string& name) const {
  const Sighting* above = sightings_.find(name);
  if (!above) return std::nullopt;
  const Eigen::Vector3d top = centre_mm(name, *above);
  for (const auto& [other, sighting] : sightings_.all()) {
    if (other == name || other == options_.gripper.mark || !sightings_.recent(other, 1)) continue;
    const Eigen::Vector3d down = top - centre_mm(other, sighting);
    const bool beneath = down.head<2>().norm() < domain_.cube_mm() / 2;
    if (beneath && std::abs(down.z() - domain_.cube_mm()) < domain_.cube_mm() / 2) return other;
  }
  return std::nullopt;
}

bool Scene::may_rest_on_another(const std::string& name, const Eigen::Vector3d& centre) const {
  for (const auto& [other, sighting] : sightings_.all()) {
    if (other == name || other == options_.gripper.mark || !sightings_.recent(other, 1)) continue;
    const Eigen::Vector3d down = (centre - centre_mm(other, sighting)) / domain_.cube_mm();
    if (down.head<2>().norm() < leaning_cubes && down.z() > 0 && down.z() < leaning_cubes) return true;
  }
  return false;
}

std::optional<std::string> Scene::held_by_somebody() const {
  const std::optional<Eigen::Vector3d> grip = grip_mm();
  for (const auto& [name, sighting] : sightings_.all()) {
    if (name == options_.gripper.mark || !sightings_.recent(name, 1)) continue;
    const Eigen::Vector3d centre = centre_mm(name, sighting);
    const bool in_gripper = grip && (centre - *grip).norm() < domain_.cube_mm();
    const bool low = centre.z() < hanging_cubes * domain_.cube_mm();
    if (!in_gripper && !low && !may_rest_on_another(name, centre)) return name;
  }
  return std::nullopt;
}

bool Scene::calm() const {
  const std::optional<Eigen::Vector3d> grip = grip_mm();
  for (const auto& [name, sighting] : sightings_.all()) {
    const bool with_the_arm = name == options_.gripper.mark || (grip && (sighting.place_mm - *grip).norm() < held_mm);
    if (with_the_arm || !sightings_.recent(name, still_looks)) continue;
    if (sightings_.still_looks(name) < still_looks) return false;
  }
  return true;
}

bool Scene::still(const std::vector<std::string>& objects) const {
  for (const std::string& name : objects) {
    if (!sightings_.recent(name, 2) || sightings_.still_looks(name) < still_looks) return false;
  }
  return true;
}

bool Scene::moved_within(std::uint64_t looks, const std::vector<std::string>& objects) const {
  return std::ranges::any_of(objects, [&](const std::string& name) {
    return sightings_.recent(name, looks) && sightings_.still_looks(name) < looks;
  });
}

}  // namespace pizarra::coordinator
