#include "agents/coordinator/geometry/elbow_room.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "agents/coordinator/geometry/sight_lines.hpp"

namespace pizarra::coordinator {

namespace {

// How far away along x a cube must stand to leave the fingers alone.
double clear_along(const ElbowRoom& room) { return room.cube_mm / 2 + room.finger_half_mm + room.margin_mm; }

bool crowds(const ElbowRoom& room, const Eigen::Vector3d& centre, const Eigen::Vector3d& other) {
  const Eigen::Vector3d apart = (other - centre).cwiseAbs();
  const double clear_across = room.narrow_mm / 2 + room.finger_mm + room.cube_mm / 2 + room.margin_mm;
  const bool at_its_height = other.z() > centre.z() - 0.75 * room.cube_mm;
  return at_its_height && apart.x() < clear_along(room) && apart.y() < clear_across && apart.y() > room.cube_mm / 2;
}

bool within_reach(const ElbowRoom& room, const Eigen::Vector2d& point) {
  return point.norm() >= room.reach_low_mm && point.norm() <= room.reach_high_mm;
}

SightLines sight_lines(const ElbowRoom& room) {
  return {
      .eyes_mm = room.eyes_mm, .cube_mm = room.cube_mm, .mark_half_mm = room.mark_half_mm, .margin_mm = room.margin_mm};
}

bool is_shown(const ElbowRoom& room, const Eigen::Vector3d& centre) { return !room.shown || room.shown(centre); }

// The shortest that will do, to whichever side; with `seen`, one that leaves every mark in sight.
std::optional<Push> shortest_push(const ElbowRoom& room, const Eigen::Vector3d& centre,
                                  const std::vector<Eigen::Vector3d>& others, bool seen) {
  constexpr double longest_mm = 150;
  constexpr double step_mm = 2;
  const double half = room.cube_mm / 2;
  const double before = half + room.finger_half_mm + 2 * room.margin_mm;
  const double pusher_half = room.pusher_mm / 2 + room.finger_mm;
  // A push ends a few millimetres off.
  const SightLines lines = sight_lines(room);
  ElbowRoom ample = room;
  ample.margin_mm += 5;
  for (double length = step_mm; length <= longest_mm; length += step_mm) {
    for (const double sign : {1.0, -1.0}) {
      if (sign > 0 && centre.z() > room.cube_mm) continue;
      const Eigen::Vector3d after = centre + Eigen::Vector3d(sign * length, 0, 0);
      if (!is_shown(room, after) || is_crowded(ample, after, others)) continue;
      const auto cover_each_other = [&](const Eigen::Vector3d& other) { return lines.cross(after, other); };
      if (seen && std::ranges::any_of(others, cover_each_other)) continue;
      const double from_x = centre.x() - sign * before;
      const auto in_the_way = [&](const Eigen::Vector3d& other) {
        const double across = std::abs(other.y() - centre.y());
        const bool of_its_pile = across < half && std::abs(other.x() - centre.x()) < half;
        if (of_its_pile) return false;
        const bool where_fingers_go =
            std::abs(other.x() - from_x) < half + room.finger_half_mm + room.margin_mm && across < pusher_half + half;
        const double ahead = sign * (other.x() - centre.x());
        const bool where_the_cube_goes = ahead > half && ahead < length + room.cube_mm && across < room.cube_mm - 2;
        return where_fingers_go || where_the_cube_goes;
      };
      const Push push{{from_x, centre.y()}, {from_x + sign * (length + 2 * room.margin_mm), centre.y()}};
      const bool possible = within_reach(room, push.from_mm) && within_reach(room, push.to_mm) &&
                            std::ranges::none_of(others, in_the_way);
      if (possible) return push;
    }
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
