#include "agents/coordinator/act/spot_choice.hpp"

#include <algorithm>

namespace pizarra::coordinator {

namespace {

// A cube comes to lie so far off the spot that it was meant for.
constexpr double off_spot_mm = 8;
// How far behind a cube stands what it hides, in cubes.
constexpr double hiding_cubes[] = {1, 1.5, 2};

std::vector<Eigen::Vector2d> on_the_table(const std::vector<Eigen::Vector3d>& centres) {
  std::vector<Eigen::Vector2d> places;
  for (const Eigen::Vector3d& centre : centres) places.emplace_back(centre.head<2>());
  return places;
}

}  // namespace

// What the spot is to have.
struct SpotChoice::Wish {
  bool at_place = false;        // a place that the domain names will do
  bool clear_of_lost = true;    // neither where others were lost, nor before them
  bool clear_of_behind = true;  // not before what may stand behind the old place; else away from that place
};

std::vector<Eigen::Vector3d> SpotChoice::standing_but(std::string_view held, bool lost) const {
  std::vector<Eigen::Vector3d> centres;
  for (const auto& [name, sighting] : scene_.sightings().all()) {
    const bool there = lost || scene_.sightings().remembered(name, options_.grace_looks);
    if (there && name != held && name != options_.gripper.mark) centres.push_back(scene_.centre_mm(name, sighting));
  }
  return standing(std::move(centres), scene_.grip_mm(), domain_.cube_mm());
}

Eigen::Vector3d SpotChoice::on_table(double x_mm, double y_mm, double edge_mm) const {
  const Eigen::Vector3d centre(x_mm, y_mm, edge_mm / 2 + options_.release_mm);
  return centre - edge_mm / 2 * scene_.view()->away();
}

// Where a cube may stand that one there hides.
std::vector<Eigen::Vector3d> SpotChoice::behind(const Eigen::Vector2d& stood) const {
  std::vector<Eigen::Vector3d> places;
  for (const double cubes : hiding_cubes) {
    const Eigen::Vector3d centre(stood.x(), stood.y(), domain_.cube_mm() / 2);
    places.emplace_back(centre + cubes * domain_.cube_mm() * scene_.view()->away());
  }
  return places;
}

// The eyes need the white around a mark too.
bool SpotChoice::is_shown(const Eigen::Vector2d& spot) const {
  const double cube = domain_.cube_mm();
  return scene_.view()->shows(on_table(spot.x(), spot.y(), cube), cube / 2 + off_spot_mm);
}

// Whether a cube there hides none of the others, and none of them hides it.
bool SpotChoice::is_in_sight(const Eigen::Vector2d& spot, const std::vector<Eigen::Vector3d>& others) const {
  const SightLines lines = scene_.sight_lines(off_spot_mm);
  const Eigen::Vector3d centre(spot.x(), spot.y(), domain_.cube_mm() / 2);
  return std::ranges::none_of(others, [&](const Eigen::Vector3d& other) { return lines.cross(centre, other); });
}

// Whether a cube there is not taken to lie at a place that the domain names.
bool SpotChoice::is_off_places(const Eigen::Vector2d& spot) const {
  const auto near = [&](const Datum* place) {
    const Eigen::Vector2d apart = spot - Eigen::Vector2d((*place)[2].number(), (*place)[3].number());
    return apart.lpNorm<Eigen::Infinity>() < domain_.cube_mm();
  };
  return std::ranges::none_of(domain_.named_places(), near);
}

TableArea SpotChoice::area() const { return TableArea::of(options_.row, domain_.cube_mm()); }

double SpotChoice::from_y_mm() const {
  const std::optional<Eigen::Vector3d> grip = scene_.grip_mm();
  return grip ? grip->y() : 0;
}

std::optional<Eigen::Vector2d> SpotChoice::spot_as(const Wish& wish, std::string_view held,
                                                   const std::optional<Eigen::Vector2d>& stood) const {
  const std::vector<Eigen::Vector3d> others = standing_but(held, wish.clear_of_lost);
  std::vector<Eigen::Vector2d> occupied = on_the_table(others);
  std::vector<Eigen::Vector3d> to_show = others;
  if (stood && wish.clear_of_behind) {
    const std::vector<Eigen::Vector3d> places = behind(*stood);
    to_show.insert(to_show.end(), places.begin(), places.end());
  }
  if (stood && !wish.clear_of_behind) occupied.push_back(*stood);
  TableArea area = this->area();
  // The lines of sight say it better.
  area.unhidden_mm = 0;
  const Shown in_sight = [&](const Eigen::Vector2d& spot) {
    return is_shown(spot) && (wish.at_place || is_off_places(spot)) && is_in_sight(spot, to_show);
  };
  return free_spot(area, occupied, from_y_mm(), in_sight);
}

// Best is a spot off all places, where the cube hides nothing and is not hidden. Where none is free, it is laid down at
// least away from its old place, or else where another was lost, which is more likely elsewhere; else at a place; else
// one that the camera shows will do, though it hides another. It never comes to lie where it lay.
std::optional<Eigen::Vector2d> SpotChoice::for_held(std::string_view held,
                                                    const std::optional<Eigen::Vector2d>& stood) const {
  constexpr Wish wishes[] = {{},
                             {.clear_of_behind = false},
                             {.clear_of_lost = false},
                             {.at_place = true},
                             {.at_place = true, .clear_of_lost = false}};
  for (const Wish& wish : wishes) {
    std::optional<Eigen::Vector2d> spot = spot_as(wish, held, stood);
    if (spot) return spot;
  }
  const Shown shown = [&](const Eigen::Vector2d& spot) { return is_shown(spot); };
  std::vector<Eigen::Vector2d> occupied = on_the_table(standing_but(held, true));
  if (stood) occupied.push_back(*stood);
  TableArea area = this->area();
  std::optional<Eigen::Vector2d> spot = free_spot(area, occupied, from_y_mm(), shown);
  if (spot) return spot;
  area.unhidden_mm = 0;
  return free_spot(area, occupied, from_y_mm(), shown);
}

}  // namespace pizarra::coordinator
