#include "agents/coordinator/geometry/border_sweeps.hpp"

#include <algorithm>
#include <cmath>

namespace pizarra::coordinator {

namespace {

// Lengths in cubes: from strip to strip, from grip to grip, where a sweep begins beyond the border, and how far out a
// border is sought.
constexpr double strip_pitch = 1.5;
constexpr double grip_pitch = 1;
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

// How far from `start_mm`, along a direction, all of a cube shows. None where it does not show there, or everywhere.
std::optional<double> border_along(const ElbowRoom& room, const Eigen::Vector2d& start_mm,
                                   const Eigen::Vector2d& along) {
  const double furthest_mm = furthest_border * room.cube_mm;
  for (double way_mm = 0; way_mm <= furthest_mm; way_mm += border_step_mm) {
    const Eigen::Vector2d at = start_mm + way_mm * along;
    if (room.shown({at.x(), at.y(), room.cube_mm / 2})) continue;
    return way_mm > 0 ? std::optional(way_mm - border_step_mm) : std::nullopt;
  }
  return std::nullopt;
}

// Up to which |y|. None where hardly anything of the strip shows.
std::optional<double> border_beside(const ElbowRoom& room, double x_mm, double side) {
  const std::optional<double> border_mm = border_along(room, {x_mm, 0}, {0, side});
  return border_mm && *border_mm >= room.cube_mm ? border_mm : std::nullopt;
}

// Up to which x. A camera that was knocked down may cut off the row itself.
std::optional<double> border_before(const ElbowRoom& room, double row_x_mm, double y_mm) {
  const double start_mm = row_x_mm - strip_pitch * room.cube_mm;
  const std::optional<double> way_mm = border_along(room, {start_mm, y_mm}, {1, 0});
  return way_mm ? std::optional(start_mm + *way_mm) : std::nullopt;
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

// A sweep, and how far the lost cube must have come to be met by it.
struct Likely {
  double way_mm;
  Push push;
};

void add_sweeps_beside(const ElbowRoom& room, double row_x_mm, const LostCube& lost,
                       const std::vector<Eigen::Vector3d>& standing, std::vector<Likely>& out) {
  for (const double off : {0.0, -strip_pitch, strip_pitch}) {
    for (const double side : {1.0, -1.0}) {
      const double x_mm = row_x_mm + off * room.cube_mm;
      const std::optional<double> border_mm = border_beside(room, x_mm, side);
      if (!border_mm) continue;
      const Strip strip{x_mm, side, *border_mm};
      if (is_free(strip, room, standing)) out.push_back({way_mm(strip, lost), sweep_over(strip, room)});
    }
  }
}

bool is_free_to_pull(const Push& pull, const ElbowRoom& room, const std::vector<Eigen::Vector3d>& standing) {
  const double half_mm = room.pusher_mm / 2 + room.finger_mm + room.cube_mm / 2 + room.margin_mm;
  const double inner_mm = pull.to_mm.x() - room.finger_half_mm - 1.5 * room.cube_mm;
  const auto is_met = [&](const Eigen::Vector3d& other) {
    return std::abs(other.y() - pull.from_mm.y()) < half_mm && other.x() > inner_mm;
  };
  return std::ranges::none_of(standing, is_met);
}

// Where a cube may have left the images by their lower border.
struct Crossing {
  double y_mm;
  double border_mm;  // the x up to which all of a cube shows
  double way_mm;     // how far it must have come
};

// Straight on from where it was lost, and every `pitch` cubes aside of that, as far as it may have come and the arm
// reaches.
std::vector<Crossing> crossings(const ElbowRoom& room, double row_x_mm, const LostCube& lost, double pitch) {
  std::vector<Crossing> out;
  const double pitch_mm = pitch * room.cube_mm;
  const double low_mm = std::max(lost.seen_mm.y() - lost.within_mm, -room.reach_high_mm);
  const double high_mm = std::min(lost.seen_mm.y() + lost.within_mm, room.reach_high_mm);
  const int first = static_cast<int>(std::ceil((low_mm - lost.seen_mm.y()) / pitch_mm));
  const int last = static_cast<int>(std::floor((high_mm - lost.seen_mm.y()) / pitch_mm));
  for (int i = first; i <= last; ++i) {
    const double aside_mm = i * pitch_mm;
    const double y_mm = lost.seen_mm.y() + aside_mm;
    const std::optional<double> border_mm = border_before(room, row_x_mm, y_mm);
    if (!border_mm) continue;
    const double before_mm = std::max(0.0, *border_mm - lost.seen_mm.x());
    out.push_back({y_mm, *border_mm, std::hypot(before_mm, aside_mm)});
  }
  return out;
}

// The x at which an arm that reaches so far ends.
double furthest_x_mm(double reach_mm, double y_mm) {
  return std::sqrt(std::max(0.0, reach_mm * reach_mm - y_mm * y_mm));
}

double touching_mm(const ElbowRoom& room) { return room.cube_mm / 2 + room.finger_half_mm; }

// Whether the arm comes to a place beyond a cube that the lower border cuts off.
bool reaches_beyond(const ElbowRoom& room, const Crossing& crossing) {
  return crossing.border_mm + touching_mm(room) <= furthest_x_mm(room.reach_high_mm, crossing.y_mm);
}

// Towards the arm.
void add_pulls_before(const ElbowRoom& room, double row_x_mm, const LostCube& lost,
                      const std::vector<Eigen::Vector3d>& standing, std::vector<Likely>& out) {
  for (const Crossing& crossing : crossings(room, row_x_mm, lost, strip_pitch)) {
    if (!reaches_beyond(room, crossing)) continue;
    const Push pull{{furthest_x_mm(room.reach_high_mm, crossing.y_mm), crossing.y_mm},
                    {crossing.border_mm - inside_mm + touching_mm(room), crossing.y_mm}};
    if (is_free_to_pull(pull, room, standing)) out.push_back({crossing.way_mm, pull});
  }
}

// Whether fingers that are open along x meet nothing that stands as they go down there.
bool is_free(const Eigen::Vector2d& grip_mm, const ElbowRoom& room, const std::vector<Eigen::Vector3d>& standing) {
  const double half_mm = room.cube_mm / 2 + room.margin_mm;
  const Eigen::Vector2d clear(room.wide_mm / 2 + room.finger_mm + half_mm, room.finger_half_mm + half_mm);
  const auto is_met = [&](const Eigen::Vector3d& other) {
    return ((other.head<2>() - grip_mm).cwiseAbs().array() < clear.array()).all();
  };
  return std::ranges::none_of(standing, is_met);
}

// Whether the fingers stand around a cube half of which lies beyond the border.
bool grips_beyond(const Eigen::Vector2d& grip_mm, double border_mm, const ElbowRoom& room) {
  return grip_mm.x() + (room.wide_mm - room.cube_mm) / 2 >= border_mm + room.cube_mm / 2;
}

// As far out as the arm comes, around where the cube may have come.
void add_grips_before(const ElbowRoom& room, double row_x_mm, const LostCube& lost,
                      const std::vector<Eigen::Vector3d>& standing, std::vector<Likely>& out) {
  for (const Crossing& crossing : crossings(room, row_x_mm, lost, grip_pitch)) {
    const Eigen::Vector2d grip_mm(furthest_x_mm(room.grip_high_mm, crossing.y_mm), crossing.y_mm);
    if (reaches_beyond(room, crossing) || !grips_beyond(grip_mm, crossing.border_mm, room)) continue;
    if (!is_free(grip_mm, room, standing)) continue;
    out.push_back(
        {crossing.way_mm, {.from_mm = grip_mm, .to_mm = grip_mm, .face_deg = fingers_side_by_side_deg, .lifts = true}});
  }
}

}  // namespace

std::vector<Push> border_sweeps(const ElbowRoom& room, double row_x_mm, const LostCube& lost,
                                const std::vector<Eigen::Vector3d>& standing) {
  if (!room.shown) return {};
  std::vector<Likely> all;
  add_sweeps_beside(room, row_x_mm, lost, standing, all);
  add_pulls_before(room, row_x_mm, lost, standing, all);
  add_grips_before(room, row_x_mm, lost, standing, all);
  std::erase_if(all, [&](const Likely& sweep) { return sweep.way_mm > lost.within_mm; });
  std::ranges::stable_sort(all, {}, &Likely::way_mm);
  std::vector<Push> sweeps;
  for (const Likely& sweep : all) sweeps.push_back(sweep.push);
  return sweeps;
}

}  // namespace pizarra::coordinator
