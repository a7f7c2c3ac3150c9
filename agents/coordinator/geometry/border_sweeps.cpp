#include "agents/coordinator/geometry/border_sweeps.hpp"

#include <algorithm>
#include <cmath>

namespace pizarra::coordinator {

namespace {

// Lengths in cubes: from strip to strip, where a sweep begins beyond the border, and how far out a border is sought.
constexpr double strip_pitch = 1.5;
constexpr double beyond = 2.5;
constexpr double furthest_border = 10;
constexpr double border_step_mm = 5;
// A swept cube comes to rest a little off, and is to show for sure.
constexpr double inside_mm = 10;
constexpr double fingers_side_by_side_deg = 90;

struct Strip {
  double x_mm;
  double side;       // 1 or -1: of y
  double border_mm;  // the |y| up to which all of a cube shows
};

// None where nothing of the strip shows, or where its end is not found.
std::optional<double> border_of(const ElbowRoom& room, double x_mm, double side) {
  const double furthest_mm = furthest_border * room.cube_mm;
  for (double y = 0; y <= furthest_mm; y += border_step_mm) {
    if (room.shown({x_mm, side * y, room.cube_mm / 2})) continue;
    return y > room.cube_mm ? std::optional(y - border_step_mm) : std::nullopt;
  }
  return std::nullopt;
}

// From where the cube was lost to where the strip begins.
double way_mm(const Strip& strip, const LostCube& lost) {
  const double aside_mm = std::max(0.0, strip.border_mm - strip.side * lost.seen_mm.y());
  return std::hypot(strip.x_mm - lost.seen_mm.x(), aside_mm);
}

bool is_free(const Strip& strip, const ElbowRoom& room, const std::vector<Eigen::Vector3d>& standing) {
  const double half_mm = room.pusher_mm / 2 + room.finger_mm + room.cube_mm / 2 + room.margin_mm;
  const double inner_mm = strip.border_mm - inside_mm - room.cube_mm;
  const auto is_met = [&](const Eigen::Vector3d& other) {
    return std::abs(other.x() - strip.x_mm) < half_mm && strip.side * other.y() > inner_mm;
  };
  return std::ranges::none_of(standing, is_met);
}

Push sweep_over(const Strip& strip, const ElbowRoom& room) {
  const double from_mm = strip.border_mm + beyond * room.cube_mm;
  const double to_mm = strip.border_mm - inside_mm + room.cube_mm / 2 + room.finger_half_mm;
  return {{strip.x_mm, strip.side * from_mm}, {strip.x_mm, strip.side * to_mm}, fingers_side_by_side_deg};
}

}  // namespace

std::vector<Push> border_sweeps(const ElbowRoom& room, double row_x_mm, const LostCube& lost,
                                const std::vector<Eigen::Vector3d>& standing) {
  std::vector<Strip> strips;
  for (const double off : {0.0, -strip_pitch, strip_pitch}) {
    for (const double side : {1.0, -1.0}) {
      const double x_mm = row_x_mm + off * room.cube_mm;
      const std::optional<double> border_mm = room.shown ? border_of(room, x_mm, side) : std::nullopt;
      if (!border_mm) continue;
      const Strip strip{x_mm, side, *border_mm};
      if (way_mm(strip, lost) <= lost.within_mm && is_free(strip, room, standing)) strips.push_back(strip);
    }
  }
  std::ranges::stable_sort(strips, {}, [&](const Strip& strip) { return way_mm(strip, lost); });
  std::vector<Push> sweeps;
  for (const Strip& strip : strips) sweeps.push_back(sweep_over(strip, room));
  return sweeps;
}

}  // namespace pizarra::coordinator
