#include "agents/coordinator/act/aim.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

#include "agents/coordinator/geometry/elbow_room.hpp"

namespace pizarra::coordinator {

namespace {

// A mark that a moment's noise hides is taken to be where it was for as many looks.
constexpr std::uint64_t tolerated_looks = 3;
// From the middle of a cube to that of one which passes over it, in cubes.
constexpr double clearing = 1.25;

}  // namespace

Datum target_name(const Datum& target) {
  if (!target.is_list()) return target;
  if (target.size() > 2) return target[2];
  return "table"_sym;
}

Result<Eigen::Vector3d> Aims::seen(std::string_view name) const {
  if (!scene_.sightings().recent(name, tolerated_looks)) {
    return fail("unseen", fmt::format("{} is not seen", name), Datum::symbol(name));
  }
  return scene_.sightings().find(name)->place_mm;
}

Result<Eigen::Vector3d> Aims::grip() const {
  const std::optional<Eigen::Vector3d> grip = scene_.grip_mm();
  if (grip) return *grip;
  const std::string& mark = options_.gripper.mark;
  return fail("unseen", fmt::format("{} is not seen, and the arm does not say where it is", mark), Datum::symbol(mark));
}

// A held object that is not known is as large as the fingers say.
double Aims::held_edge_mm(std::string_view held) const {
  const double like_mm = domain_.edge_like(scene_.opening_mm().value_or(0)).value_or(domain_.cube_mm());
  return scene_.sightings().find(held) ? domain_.edge_mm(held) : like_mm;
}

// The held object faces the camera, whichever way the one below it is turned: middle goes over middle.
Result<Eigen::Vector3d> Aims::on_top_of(std::string_view lower, std::string_view held) const {
  const Result<Eigen::Vector3d> mark = seen(lower);
  if (!mark) return mark;
  const std::string name(lower);
  const double edge = domain_.edge_mm(held);
  const Eigen::Vector3d middle = scene_.centre_mm(name, *scene_.sightings().find(lower));
  const Eigen::Vector3d front = middle - edge / 2 * scene_.view()->away();
  const double above_mm = (domain_.edge_mm(lower) + edge) / 2 + options_.release_mm;
  return Eigen::Vector3d(front + above_mm * Eigen::Vector3d::UnitZ());
}

double Aims::clear_height_mm() const {
  double highest_mm = 0;
  for (const Eigen::Vector3d& centre : spots_.standing_but("", true)) highest_mm = std::max(highest_mm, centre.z());
  return highest_mm + clearing * domain_.cube_mm();
}

Result<Eigen::Vector3d> Aims::free_spot_for(const Datum& target) {
  const std::string_view held = target[1].text();
  if (!spot_) {
    std::optional<Eigen::Vector2d> stood;
    if (target.size() == 4) stood.emplace(target[2].number(), target[3].number());
    spot_ = spots_.for_held(held, stood);
  }
  if (!spot_) return fail("no-room", "there is no free spot on the table", Datum::symbol(held));
  return spots_.on_table(spot_->x(), spot_->y(), held_edge_mm(held));
}

// One place must not be judged by the eyes, and the next by the gripper alone: the arm would go to and fro between
// them.
Eigen::Vector3d Aims::held_place(const std::string& held, const Eigen::Vector3d& grip) {
  const Eigen::Vector3d by_gripper = grip + (domain_.cube_mm() - held_edge_mm(held)) / 2 * scene_.view()->away();
  const bool is_seen = !options_.open_loop && scene_.sightings().recent(held, 1);
  if (is_seen) held_off_mm_ = scene_.sightings().find(held)->place_mm - by_gripper;
  return by_gripper + held_off_mm_;
}

Result<Aim> Aims::at(const Datum& target) {
  if (!scene_.view()) return fail("unseen", "the camera has not told its focal length and centre yet");
  const Result<Eigen::Vector3d> grip = this->grip();
  if (!grip) return fail(grip);
  if (target.is_symbol()) {
    const Result<Eigen::Vector3d> object = seen(target.text());
    if (!object) return fail(object);
    const Eigen::Vector3d to_mark = -scene_.mark_to_front_mm();
    const std::string name(target.text());
    Eigen::Vector3d front = *object + scene_.face_to_fingers_mm(name) - scene_.set_back_mm(name);
    const double stands_on_mm = std::max(0.0, object->z() - domain_.edge_mm(name) / 2);
    front.z() = std::max(front.z(), stands_on_mm + options_.gripper.finger_below_mm);
    return Aim{*grip + to_mark, front + to_mark, grip->z(), scene_.foot_mm()};
  }
  if (target.size() < 2) return fail("bad-target", "this is no target of a micro-task", target);
  const std::string_view held = target[1].text();
  const Eigen::Vector3d followed = held_place(std::string(held), *grip);
  Result<Eigen::Vector3d> wanted = fail("bad-target", "this is no target of a micro-task", target);
  if (target.is_form("on-top") && target.size() == 3) {
    wanted = on_top_of(target[2].text(), held);
  } else if (target.is_form("free-spot")) {
    wanted = free_spot_for(target);
  } else if (target.is_form("at-place") && target.size() == 3) {
    const Datum* spot = domain_.named_place(target[2].text());
    if (!spot) return fail("unknown-place", "perception has no (spot PLACE X Y) for this place", target[2]);
    wanted = spots_.on_table((*spot)[2].number(), (*spot)[3].number(), held_edge_mm(held));
  }
  if (!wanted) return fail(wanted);
  return Aim{followed, *wanted, grip->z(), scene_.foot_mm()};
}

double Aims::opening_around(std::string_view object, double wide_mm) const {
  const Sighting* centre = scene_.sightings().find(object);
  if (!centre) return options_.gripper.openings.normal_mm;
  std::vector<Eigen::Vector3d> neighbours;
  for (const auto& [name, sighting] : scene_.sightings().all()) {
    if (name == object || name == options_.gripper.mark) continue;
    neighbours.push_back(scene_.centre_mm(name, sighting));
  }
  const Eigen::Vector3d middle = scene_.centre_mm(std::string(object), *centre);
  neighbours = seen_from_fingers(scene_.fingers_deg(object), middle, std::move(neighbours));
  return opening_between(middle, neighbours, domain_.cube_mm(), options_.gripper.finger_mm,
                         options_.gripper.openings.narrow_mm, wide_mm);
}

// Seen from the arm's foot. The tool's axis stands behind the mark.
ServoErrors servo_errors(const Aim& aim, const CameraView& view, double mark_before_grip_mm, double travel_mm) {
  const Eigen::Vector3d tool_mm = mark_before_grip_mm * view.away() - aim.foot_mm;
  const Eigen::Vector3d now = aim.followed_mm + tool_mm;
  const Eigen::Vector3d then = aim.wanted_mm + tool_mm;
  const double radius = std::hypot(then.x(), then.y());
  const double turn =
      std::remainder(std::atan2(then.y(), then.x()) - std::atan2(now.y(), now.x()), 2 * std::numbers::pi);
  return {.across_mm = turn * radius,
          .bearing_deg = turn * 180 / std::numbers::pi,
          .along_mm = radius - std::hypot(now.x(), now.y()),
          .down_mm = now.z() - then.z(),
          .clearance_mm = travel_mm - aim.grip_height_mm};
}

ServoPixels servo_pixels(const Aim& aim, const CameraView& view) {
  const Eigen::Vector3d missing = aim.wanted_mm - aim.followed_mm;
  const double px_per_mm = view.focal_px() / view.sight(aim.wanted_mm).depth_mm;
  return {missing.dot(view.right()) * px_per_mm, -missing.z() * px_per_mm, missing.dot(view.away())};
}

}  // namespace pizarra::coordinator
