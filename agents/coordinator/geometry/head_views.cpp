#include "agents/coordinator/geometry/head_views.hpp"

#include <algorithm>
#include <cmath>

namespace pizarra::coordinator {

namespace {

constexpr std::size_t most_views = 6;
// Between neighbouring turns, of which the best are chosen. Further from the middle the cameras do not look at the arm.
constexpr double pan_step_deg = 4;
constexpr double tilt_step_deg = 4;
constexpr double most_pan_deg = 80;
constexpr double most_tilt_deg = 32;
// Between the points of the table.
constexpr double grid_mm = 40;
// A view that shows fewer points which no other shows is not worth a turn.
constexpr std::size_t least_points = 3;

bool is_axis(const Datum& axis) {
  return axis.size() == 4 && std::ranges::all_of(axis.items(), &Datum::is_number) &&
         axis[0].number() <= axis[1].number();
}

// The middle first, and further turns after nearer ones; a turn up or down counts more, since what is high in the
// gripper is to be seen too.
std::vector<HeadTurn> turns_within(const HeadRange& range) {
  std::vector<HeadTurn> turns;
  for (double tilt = -most_tilt_deg; tilt <= most_tilt_deg; tilt += tilt_step_deg) {
    if (tilt < range.tilt_low_deg || tilt > range.tilt_high_deg) continue;
    for (double pan = -most_pan_deg; pan <= most_pan_deg; pan += pan_step_deg) {
      if (pan >= range.pan_low_deg && pan <= range.pan_high_deg) turns.push_back({pan, tilt});
    }
  }
  std::ranges::stable_sort(turns, {}, [](const HeadTurn& turn) {
    constexpr double tilt_counts = 3;
    return std::abs(turn.pan_deg) + tilt_counts * std::abs(turn.tilt_deg);
  });
  return turns;
}

using Points = std::vector<Eigen::Vector3d>;

void erase_shown(Points& points, const CameraView& view, double around_mm) {
  std::erase_if(points, [&](const Eigen::Vector3d& point) { return view.shows(point, around_mm); });
}

}  // namespace

Result<HeadRange> head_range_from_fact(const Datum& fact) {
  const bool sound = fact.is_form("pan-tilt-unit") && fact.size() == 3 && is_axis(fact[1]) && is_axis(fact[2]);
  if (!sound) return fail("bad-pan-tilt-unit", "a pan-tilt unit tells the ends of both of its axes", fact);
  return HeadRange{fact[1][0].number(), fact[1][1].number(), fact[2][0].number(), fact[2][1].number()};
}

std::vector<Eigen::Vector3d> table_within(const ElbowRoom& room, const Eigen::Vector3d& foot_mm,
                                          const HeadCamera& camera) {
  const CameraView view(camera.pose, camera.model);
  Points points;
  for (double ahead = 0; ahead <= room.grip_high_mm; ahead += grid_mm) {
    for (double aside = -room.grip_high_mm; aside <= room.grip_high_mm; aside += grid_mm) {
      const double radius_mm = std::hypot(ahead, aside);
      if (radius_mm < room.reach_low_mm || radius_mm > room.grip_high_mm) continue;
      const double before_mm = ahead + room.cube_mm / 2;
      points.push_back(foot_mm - before_mm * view.away() + aside * view.right() +
                       room.cube_mm / 2 * Eigen::Vector3d::UnitZ());
    }
  }
  return points;
}

std::vector<HeadTurn> views_of(const HeadCamera& camera, const HeadRange& range, const HeadTurn& now,
                               std::vector<Eigen::Vector3d> points, double around_mm) {
  erase_shown(points, CameraView(camera.pose, camera.model, now), around_mm);
  const std::vector<HeadTurn> turns = turns_within(range);
  std::vector<HeadTurn> views;
  while (views.size() < most_views) {
    const HeadTurn* best = nullptr;
    std::size_t most = least_points - 1;
    for (const HeadTurn& turn : turns) {
      const CameraView view(camera.pose, camera.model, turn);
      const auto shown = static_cast<std::size_t>(
          std::ranges::count_if(points, [&](const Eigen::Vector3d& point) { return view.shows(point, around_mm); }));
      if (shown <= most) continue;
      most = shown;
      best = &turn;
    }
    if (!best) break;
    views.push_back(*best);
    erase_shown(points, CameraView(camera.pose, camera.model, *best), around_mm);
  }
  return views;
}

std::optional<HeadTurn> turn_that_shows(const HeadCamera& camera, const HeadRange& range,
                                        const std::vector<Eigen::Vector3d>& points, double around_mm) {
  for (const HeadTurn& turn : turns_within(range)) {
    const CameraView view(camera.pose, camera.model, turn);
    const bool all =
        std::ranges::all_of(points, [&](const Eigen::Vector3d& point) { return view.shows(point, around_mm); });
    if (all) return turn;
  }
  return std::nullopt;
}

}  // namespace pizarra::coordinator
