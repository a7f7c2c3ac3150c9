#include "drivers/simulation/render/second_lamp.hpp"

#include <algorithm>

#include "drivers/simulation/render/convex.hpp"

namespace pizarra::simulation {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// A face square to it is a little brighter than one in the light of the first lamp.
constexpr double lamp_gain = 1.2;
// The shadow of what reaches higher, of the height of the lamp above a face, is left out: it would have no end.
constexpr double highest_caster = 0.95;

Vector3d place_of(const LampConfig& lamp) { return {lamp.at_mm[0], lamp.at_mm[1], lamp.at_mm[2]}; }

double light_of_lamp(const LampConfig& lamp, const Vector3d& on, const Vector3d& normal) {
  return lamp.part * lamp_gain * std::max(0.0, normal.dot((place_of(lamp) - on).normalized()));
}

double light_of_rest(const LampConfig& lamp, const Vector3d& normal) {
  return (1 - lamp.part) * lit(Colour::Ones(), normal).x();
}

Vector3d middle_of(const Solid& solid, const Face& face) {
  Vector3d sum = Vector3d::Zero();
  for (const int vertex : face.vertices) sum += solid.vertices[static_cast<std::size_t>(vertex)];
  return sum / static_cast<double>(face.vertices.size());
}

Points corners_of(const Solid& solid, const Face& face) {
  Points out;
  for (const int vertex : face.vertices) out.push_back(solid.vertices[static_cast<std::size_t>(vertex)]);
  return out;
}

// A plane that shadows fall on.
struct Ground {
  Ground(const Vector3d& on, const Vector3d& away, const Vector3d& lamp_mm)
      : origin(on),
        normal(away),
        right(away.unitOrthogonal()),
        ahead(away.cross(right)),
        lamp(lamp_mm),
        lamp_height(height(lamp_mm)) {}

  double height(const Vector3d& point) const { return normal.dot(point - origin); }
  Vector2d flat(const Vector3d& point) const { return {right.dot(point - origin), ahead.dot(point - origin)}; }
  Vector3d back(const Vector2d& point) const { return origin + right * point.x() + ahead * point.y(); }
  // Where the ray from the lamp through the point meets it.
  Vector2d shadow(const Vector3d& point) const {
    return flat(lamp + (point - lamp) * (lamp_height / (lamp_height - height(point))));
  }

  Vector3d origin;
  Vector3d normal;
  Vector3d right;
  Vector3d ahead;
  Vector3d lamp;
  double lamp_height;
};

// The corners of the part of the solid that lies above the plane.
Points above(const Ground& ground, const Solid& solid) {
  Points out;
  for (const Face& face : solid.faces) {
    for (std::size_t i = 0; i < face.vertices.size(); ++i) {
      const Vector3d& from = solid.vertices[static_cast<std::size_t>(face.vertices[i])];
      const Vector3d& to = solid.vertices[static_cast<std::size_t>(face.vertices[(i + 1) % face.vertices.size()])];
      const double low = ground.height(from);
      const double high = ground.height(to);
      if (low >= 0) out.push_back(from);
      if ((low >= 0) != (high >= 0)) out.push_back(from + (to - from) * (low / (low - high)));
    }
  }
  return out;
}

// Nothing where the lamp does not shine past the solid onto the plane.
Polygon shadow_of(const Ground& ground, const Solid& solid) {
  Points points = above(ground, solid);
  const double limit = highest_caster * ground.lamp_height;
  const bool casts =
      !points.empty() && std::ranges::all_of(points, [&](const Vector3d& p) { return ground.height(p) < limit; });
  if (!casts) return {};
  Polygon shadow;
  for (const Vector3d& point : points) shadow.push_back(ground.shadow(point));
  return convex_hull(std::move(shadow));
}

}  // namespace

void add_light(const LampConfig& lamp, std::vector<Solid>& solids) {
  for (Solid& solid : solids) {
    for (Face& face : solid.faces) {
      const Vector3d middle = middle_of(solid, face);
      const double before = lit(Colour::Ones(), face.normal).x();
      const double now = light_of_rest(lamp, face.normal) + light_of_lamp(lamp, middle, face.normal);
      const auto brighter = static_cast<float>(now / before);
      face.colour *= brighter;
      if (face.photograph) face.photograph->light *= brighter;
      for (Decal& decal : face.decals) decal.colour *= brighter;
    }
  }
}

double part_in_shadow(const LampConfig& lamp, const Vector3d& on, const Vector3d& normal) {
  const double taken = light_of_lamp(lamp, on, normal);
  return taken / (taken + light_of_rest(lamp, normal));
}

std::vector<Points> shadows_on(const LampConfig& lamp, const Points& border, const Vector3d& normal,
                               std::span<const Solid* const> casters) {
  const Ground ground(border.front(), normal, place_of(lamp));
  std::vector<Points> out;
  if (ground.lamp_height <= 0) return out;
  Polygon flat_border;
  for (const Vector3d& corner : border) flat_border.push_back(ground.flat(corner));
  for (const Solid* caster : casters) {
    const Polygon shadow = part_within(flat_border, shadow_of(ground, *caster));
    if (shadow.size() < 3) continue;
    Points& points = out.emplace_back();
    for (const Vector2d& corner : shadow) points.push_back(ground.back(corner));
  }
  return out;
}

void add_shadows(const LampConfig& lamp, std::vector<Solid>& solids, std::size_t receivers) {
  for (std::size_t i = 0; i < receivers; ++i) {
    std::vector<const Solid*> others;
    for (const Solid& other : solids) {
      if (&other != &solids[i]) others.push_back(&other);
    }
    for (Face& face : solids[i].faces) {
      face.shadows = shadows_on(lamp, corners_of(solids[i], face), face.normal, others);
      face.shadow_dark = static_cast<float>(part_in_shadow(lamp, middle_of(solids[i], face), face.normal));
    }
  }
}

}  // namespace pizarra::simulation
