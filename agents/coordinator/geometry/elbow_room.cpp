#include "agents/coordinator/geometry/elbow_room.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "agents/coordinator/geometry/sight_lines.hpp"

namespace pizarra::coordinator {

namespace {

// How far away along x a cube must stand to leave the fingers alone.
double clear_along(const ElbowRoom& room) { return room.cube_mm / 2 + room.finger_half_mm + room.margin_mm; }

bool meets_palm(const ElbowRoom& room, double grip_height_mm, const Eigen::Vector3d& other) {
  return other.z() + room.cube_mm / 2 > grip_height_mm + room.palm_above_mm;
}

// How far away a cube must stand from the middle of a palm that reaches so far.
double palm_clear_of(const ElbowRoom& room, double palm_half_mm) {
  return palm_half_mm + room.cube_mm / 2 + room.margin_mm;
}

bool crowds(const ElbowRoom& room, const Eigen::Vector3d& centre, const Eigen::Vector3d& other) {
  const Eigen::Vector3d apart = (other - centre).cwiseAbs();
  const double clear_across = room.narrow_mm / 2 + room.finger_mm + room.cube_mm / 2 + room.margin_mm;
  const bool at_its_height = other.z() > centre.z() - 0.75 * room.cube_mm;
  const bool in_the_fingers_way = at_its_height && apart.x() < clear_along(room) && apart.y() < clear_across;
  const bool in_the_palms_way = meets_palm(room, centre.z(), other) &&
                                apart.x() < palm_clear_of(room, room.palm_deep_mm) &&
                                apart.y() < palm_clear_of(room, room.palm_half_mm);
  return (in_the_fingers_way || in_the_palms_way) && apart.y() > room.cube_mm / 2;
}

bool within_reach(const ElbowRoom& room, const Eigen::Vector2d& point) {
  return point.norm() >= room.reach_low_mm && point.norm() <= room.reach_high_mm;
}

SightLines sight_lines(const ElbowRoom& room) {
  return {
      .eyes_mm = room.eyes_mm, .cube_mm = room.cube_mm, .mark_half_mm = room.mark_half_mm, .margin_mm = room.margin_mm};
}

bool is_shown(const ElbowRoom& room, const Eigen::Vector3d& centre) { return !room.shown || room.shown(centre); }

// How the gripper is turned to push, and how far fingers and palm then reach from its middle, along the push and
// across.
struct Pusher {
  double face_deg;
  double along_mm;
  double across_mm;
  double palm_along_mm;
  double palm_across_mm;
};

std::array<Pusher, 2> pushers(const ElbowRoom& room) {
  const double fingers_mm = room.pusher_mm / 2 + room.finger_mm;
  return {Pusher{0, room.finger_half_mm, fingers_mm, room.palm_deep_mm, room.palm_half_mm},
          Pusher{90, fingers_mm, room.finger_half_mm, room.palm_half_mm, room.palm_deep_mm}};
}

// A push of the cube at `centre` along x, to the side and by the length that the sign and the size of `by_mm` say.
Push push_along_x(const ElbowRoom& room, const Pusher& pusher, const Eigen::Vector3d& centre, double by_mm) {
  const double sign = by_mm > 0 ? 1 : -1;
  const double from_x = centre.x() - sign * (room.cube_mm / 2 + pusher.along_mm + 2 * room.margin_mm);
  return {{from_x, centre.y()}, {from_x + by_mm + sign * 2 * room.margin_mm, centre.y()}, pusher.face_deg};
}

// Whether fingers, palm or the pushed cube would touch what stands there.
bool is_met(const ElbowRoom& room, const Pusher& pusher, const Eigen::Vector3d& centre, double by_mm,
            const Eigen::Vector3d& other) {
  const double half = room.cube_mm / 2;
  const double sign = by_mm > 0 ? 1 : -1;
  const double across = std::abs(other.y() - centre.y());
  const bool of_its_pile = across < half && std::abs(other.x() - centre.x()) < half;
  if (of_its_pile) return false;
  const Push push = push_along_x(room, pusher, centre, by_mm);
  const bool where_fingers_go = std::abs(other.x() - push.from_mm.x()) < half + pusher.along_mm + room.margin_mm &&
                                across < pusher.across_mm + half;
  const double ahead = sign * (other.x() - centre.x());
  const bool where_the_cube_goes = ahead > half && ahead < std::abs(by_mm) + room.cube_mm && across < room.cube_mm - 2;
  const double nearest_x =
      std::clamp(other.x(), std::min(push.from_mm.x(), push.to_mm.x()), std::max(push.from_mm.x(), push.to_mm.x()));
  const bool where_the_palm_goes = meets_palm(room, room.push_height_mm, other) &&
                                   std::abs(other.x() - nearest_x) < palm_clear_of(room, pusher.palm_along_mm) &&
                                   across < palm_clear_of(room, pusher.palm_across_mm);
  return where_fingers_go || where_the_cube_goes || where_the_palm_goes;
}

// The shortest that will do, to whichever side; with `seen`, one that leaves every mark in sight.
std::optional<Push> shortest_push(const ElbowRoom& room, const Pusher& pusher, const Eigen::Vector3d& centre,
                                  const std::vector<Eigen::Vector3d>& others, bool seen) {
  constexpr double longest_mm = 150;
  constexpr double step_mm = 2;
  // A push ends a few millimetres off.
  const SightLines lines = sight_lines(room);
  ElbowRoom ample = room;
  ample.margin_mm += 5;
  for (double length = step_mm; length <= longest_mm; length += step_mm) {
    for (const double by_mm : {length, -length}) {
      if (by_mm > 0 && centre.z() > room.cube_mm) continue;
      const Eigen::Vector3d after = centre + Eigen::Vector3d(by_mm, 0, 0);
      if (!is_shown(room, after) || is_crowded(ample, after, others)) continue;
      const auto cover_each_other = [&](const Eigen::Vector3d& other) { return lines.cross(after, other); };
      if (seen && std::ranges::any_of(others, cover_each_other)) continue;
      const auto in_the_way = [&](const Eigen::Vector3d& other) { return is_met(room, pusher, centre, by_mm, other); };
      const Push push = push_along_x(room, pusher, centre, by_mm);
      const bool possible = within_reach(room, push.from_mm) && within_reach(room, push.to_mm) &&
                            std::ranges::none_of(others, in_the_way);
      if (possible) return push;
    }
  }
  return std::nullopt;
}

std::optional<Push> shortest_push(const ElbowRoom& room, const Eigen::Vector3d& centre,
                                  const std::vector<Eigen::Vector3d>& others, bool seen) {
  for (const Pusher& pusher : pushers(room)) {
    std::optional<Push> push = shortest_push(room, pusher, centre, others, seen);
    if (push) return push;
  }
  return std::nullopt;
}

}  // namespace

std::vector<Eigen::Vector3d> seen_from_fingers(double fingers_deg, const Eigen::Vector3d& centre,
                                               std::vector<Eigen::Vector3d> others) {
  const Eigen::AngleAxisd back(-fingers_deg * std::numbers::pi / 180, Eigen::Vector3d::UnitZ());
  for (Eigen::Vector3d& other : others) other = centre + back * (other - centre);
  return others;
}

bool is_crowded(const ElbowRoom& room, const Eigen::Vector3d& centre, const std::vector<Eigen::Vector3d>& others) {
  const std::vector<Eigen::Vector3d> beside = seen_from_fingers(room.fingers_deg, centre, others);
  return std::ranges::any_of(beside, [&](const Eigen::Vector3d& other) { return crowds(room, centre, other); });
}

std::optional<Push> push_for_room(const ElbowRoom& room, const Eigen::Vector3d& centre,
                                  const std::vector<Eigen::Vector3d>& others) {
  if (!is_crowded(room, centre, others)) return std::nullopt;
  const std::optional<Push> in_sight = shortest_push(room, centre, others, true);
  return in_sight ? in_sight : shortest_push(room, centre, others, false);
}

std::optional<Push> push_into_view(const ElbowRoom& room, const Eigen::Vector3d& centre,
                                   const std::vector<Eigen::Vector3d>& others) {
  if (is_shown(room, centre)) return std::nullopt;
  return shortest_push(room, centre, others, false);
}

Push push_over_from(const ElbowRoom& room, const Eigen::Vector3d& centre) {
  // A cube on its edge reaches half its diagonal.
  const double before = std::numbers::sqrt2 / 2 * room.cube_mm + room.finger_half_mm + 2 * room.margin_mm;
  const double length = room.cube_mm / 2;
  // The fingers come to where its middle would be that much further on.
  const double cube_goes = length + room.cube_mm / 2;
  const Eigen::Vector3d towards = centre + Eigen::Vector3d(cube_goes, 0, 0);
  const Eigen::Vector3d away = centre - Eigen::Vector3d(cube_goes, 0, 0);
  const double sign = is_shown(room, towards) || !is_shown(room, away) ? 1 : -1;
  return {{centre.x() - sign * before, centre.y()}, {centre.x() + sign * length, centre.y()}};
}

}  // namespace pizarra::coordinator
