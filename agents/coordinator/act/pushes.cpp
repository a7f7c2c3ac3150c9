#include "agents/coordinator/act/pushes.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <limits>

#include "agents/coordinator/act/servo_loop.hpp"
#include "agents/coordinator/geometry/border_sweeps.hpp"

namespace pizarra::coordinator {

namespace {

// The highest pile that can be pushed, in cube sizes: what stands higher would topple, and meet the gripper's palm.
constexpr double highest_pile = 2;
// The palm passes over a pile of two, and the fingers still reach the lower one.
constexpr double grip_height = 0.7;
// Where a cube on its edge is pushed, above its centre and in cube sizes: the plate with the gripper's mark, which is
// ahead of the fingers, passes over it.
constexpr double above_centre = 0.15;
constexpr double careful_percent = 30;

}  // namespace

ElbowRoom Pushes::elbow_room() const {
  ElbowRoom room;
  room.cube_mm = domain_.cube_mm();
  room.push_height_mm = grip_height * domain_.cube_mm();
  room.palm_half_mm = options_.gripper.outline.half_width_mm;
  room.finger_mm = options_.gripper.finger_mm;
  room.narrow_mm = options_.gripper.openings.narrow_mm;
  room.wide_mm = options_.gripper.openings.wide_mm;
  if (!surroundings_.scene().view()) return room;
  const auto eyes = surroundings_.scene().view()->eyes();
  room.eyes_mm.assign(eyes.begin(), eyes.end());
  room.shown = [this](const Eigen::Vector3d& centre) {
    const CameraView& view = *surroundings_.scene().view();
    const double half_mm = domain_.cube_mm() / 2;
    // A mark is recognised by the face around it.
    return view.shows(centre - half_mm * view.away(), half_mm);
  };
  return room;
}

std::optional<Push> Pushes::push_for(std::string_view object) const {
  const Sightings& sightings = surroundings_.scene().sightings();
  const Sighting* target = sightings.find(object);
  if (!target || target->place_mm.z() > highest_pile * domain_.cube_mm()) return std::nullopt;
  std::vector<Eigen::Vector3d> others;
  for (const auto& [name, sighting] : sightings.all()) {
    if (name != object && name != options_.gripper.mark)
      others.push_back(surroundings_.scene().centre_mm(name, sighting));
  }
  ElbowRoom room = elbow_room();
  room.fingers_deg = surroundings_.scene().fingers_deg(object);
  return push_for_room(room, surroundings_.scene().centre_mm(std::string(object), *target), others);
}

Task<Result<void>> Pushes::make_room(std::string object) {
  const std::optional<Push> push = push_for(object);
  if (!push) co_return Result<void>();
  const std::string sentence = fmt::format("{} stands too close to its neighbour: pushing it out of the row", object);
  co_await story_.tell("servo", sentence, Datum::symbol(object));
  const Result<void> pushed = co_await sweep(*push);
  co_return pushed;
}

Task<Result<void>> Pushes::push_over(std::string object) {
  const Sighting* seen = surroundings_.scene().sightings().find(object);
  if (!seen) co_return fail("lost-sight", fmt::format("{} is not seen", object), Datum::symbol(object));
  const double cube = domain_.cube_mm();
  const Eigen::Vector3d centre = surroundings_.scene().centre_mm(object, *seen);
  conditions_.commit();
  const std::optional<Push> inwards = sweep_inwards(object);
  if (inwards) co_return co_await sweep(*inwards);
  const Push push = push_over_from(elbow_room(), centre);
  const double height = std::max(centre.z() + above_centre * cube, grip_height * cube);
  const Result<void> pushed = co_await push_along(push, height);
  co_return pushed;
}

// A cube that the images cut off is not measured well enough to be grasped.
std::optional<Push> Pushes::sweep_inwards(const std::string& object) const {
  const Sighting* seen = surroundings_.scene().sightings().find(object);
  const ElbowRoom room = elbow_room();
  if (!seen || !room.shown) return std::nullopt;
  const Eigen::Vector3d centre = surroundings_.scene().centre_mm(object, *seen);
  if (room.shown(centre)) return std::nullopt;
  const LostCube lies{centre, domain_.cube_mm() / 2};
  const std::vector<Push> sweeps = border_sweeps(room, centre.x(), lies, standing_but(object));
  const auto beside = std::ranges::find(sweeps, false, &Push::lifts);
  return beside == sweeps.end() ? std::nullopt : std::optional(*beside);
}

std::vector<Eigen::Vector3d> Pushes::standing_but(const std::string& object) const {
  const Scene& scene = surroundings_.scene();
  std::vector<Eigen::Vector3d> standing;
  for (const auto& [name, sighting] : scene.sightings().all()) {
    const bool there = scene.sightings().remembered(name, options_.grace_looks);
    const bool other = name != object && name != options_.gripper.mark;
    if (there && other) standing.push_back(scene.centre_mm(name, sighting));
  }
  return standing;
}

std::vector<Push> Pushes::pushes_into_view(const std::string& missing) const {
  const Scene& scene = surroundings_.scene();
  const ElbowRoom room = elbow_room();
  std::vector<Push> pushes;
  for (const auto& [name, sighting] : scene.sightings().all()) {
    const bool other = name != missing && name != options_.gripper.mark;
    const bool lost = other && !scene.sightings().remembered(name, options_.grace_looks);
    Eigen::Vector3d centre = scene.centre_mm(name, sighting);
    if (!lost || centre.z() > room.cube_mm) continue;
    centre.z() = room.cube_mm / 2;
    const std::optional<Push> push = push_into_view(room, centre, standing_but(name));
    if (push) pushes.push_back(*push);
  }
  return pushes;
}

bool Pushes::lay_cut_off(const std::string& object) const {
  const Sighting* last = surroundings_.scene().sightings().find(object);
  const ElbowRoom room = elbow_room();
  if (!last || !room.shown) return false;
  const Eigen::Vector3d centre = surroundings_.scene().centre_mm(object, *last);
  return centre.z() < room.cube_mm && !room.shown(centre);
}

std::vector<Push> Pushes::sweeps_for(const std::string& missing, bool was_here) const {
  std::vector<Push> sweeps = pushes_into_view(missing);
  const Scene& scene = surroundings_.scene();
  const Sighting* last = scene.sightings().find(missing);
  if (!last && !was_here) return sweeps;
  const forms::CubeRow& row = options_.row;
  LostCube lost{{row.x_mm, (row.y_low_mm + row.y_high_mm) / 2, 0}, std::numeric_limits<double>::infinity()};
  if (last) lost = {scene.centre_mm(missing, *last), scene.falls_within_mm(*last)};
  const std::vector<Push> beside = border_sweeps(elbow_room(), options_.row.x_mm, lost, standing_but(missing));
  sweeps.insert(sweeps.end(), beside.begin(), beside.end());
  return sweeps;
}

Task<Result<void>> Pushes::sweep(Push push) {
  const double height_mm = grip_height * domain_.cube_mm();
  Result<void> swept;
  if (push.lifts) swept = co_await lift_at(push, height_mm);
  if (!push.lifts) swept = co_await push_along(push, height_mm);
  // The end effector's mark shows only while the fingers look at the camera.
  const Result<void> squared = co_await arm_.face(0);
  if (!swept) co_return swept;
  co_return squared;
}

Task<Result<void>> Pushes::lift_at(Push push, double height_mm) {
  const Result<double> opened = co_await arm_.grip(options_.gripper.openings.wide_mm);
  if (!opened) co_return fail(opened);
  const Eigen::Vector3d above(push.from_mm.x(), push.from_mm.y(), options_.travel_height_mm);
  const Eigen::Vector3d around(push.from_mm.x(), push.from_mm.y(), height_mm);
  Result<void> done = co_await arm_.face(push.face_deg);
  if (done) done = may_move(surroundings_, conditions_);
  if (done) done = co_await arm_.move_to(above);
  if (done) done = may_move(surroundings_, conditions_);
  if (done) done = co_await arm_.move_to(around);
  if (!done) co_return done;
  const Result<double> closed = co_await arm_.grip(0);
  if (!closed) co_return fail(closed);
  const Result<void> lifted = co_await arm_.move_to(above);
  co_return lifted;
}

Task<Result<void>> Pushes::push_along(Push push, double height_mm) {
  const double pusher_mm = ElbowRoom().pusher_mm;
  const Result<double> narrowed = co_await arm_.grip(pusher_mm);
  if (!narrowed) co_return fail(narrowed);
  const double high = options_.travel_height_mm;
  const Eigen::Vector3d ways[] = {{push.from_mm.x(), push.from_mm.y(), high},
                                  {push.from_mm.x(), push.from_mm.y(), height_mm},
                                  {push.to_mm.x(), push.to_mm.y(), height_mm},
                                  {push.to_mm.x(), push.to_mm.y(), high}};
  Result<void> done = co_await arm_.face(push.face_deg);
  // An operator may have set a speed that is lower still.
  const double usual_percent = co_await arm_.speed_percent();
  for (std::size_t i = 0; done && i < std::size(ways); ++i) {
    done = may_move(surroundings_, conditions_);
    if (!done) break;
    const bool pushes = i == 2;
    const Datum speed = list("speed"_sym, pushes ? std::min(careful_percent, usual_percent) : usual_percent);
    const Result<Datum> set = co_await arm_.ask(speed);
    if (!set) done = fail(set);
    if (set) done = co_await arm_.move_to(ways[i]);
  }
  const Datum usual = list("speed"_sym, usual_percent);
  const Result<Datum> restored = co_await arm_.ask(usual);
  if (!restored && done) co_return fail(restored);
  co_return done;
}

}  // namespace pizarra::coordinator
