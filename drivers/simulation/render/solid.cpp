#include "drivers/simulation/render/solid.hpp"

#include <cmath>
#include <numbers>

namespace pizarra::simulation {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

Face make_face(const Points& points, std::vector<int> vertices, const Colour& colour) {
  const Vector3d& a = points[static_cast<std::size_t>(vertices[0])];
  const Vector3d& b = points[static_cast<std::size_t>(vertices[1])];
  const Vector3d& c = points[static_cast<std::size_t>(vertices[2])];
  const Vector3d normal = (b - a).cross(c - b).normalized();
  return {std::move(vertices), normal, lit(colour, normal), {}, {}, 0};
}

}  // namespace

Vector3d lamp() { return Vector3d(0.52, -0.36, 0.78).normalized(); }

Colour lit(const Colour& colour, const Vector3d& normal) {
  return colour * static_cast<float>(0.67 + 0.33 * normal.dot(lamp()));
}

Solid make_box(const Eigen::Isometry3d& pose, const Vector3d& centre_mm, const Vector3d& half_mm,
               const Colour& colour) {
  Solid solid;
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3d sign((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1, (corner & 4) != 0 ? 1 : -1);
    solid.vertices.push_back(pose * (centre_mm + half_mm.cwiseProduct(sign)));
  }
  for (const auto& vertices : {std::vector{1, 3, 7, 5}, std::vector{0, 4, 6, 2}, std::vector{2, 6, 7, 3},
                               std::vector{0, 1, 5, 4}, std::vector{4, 5, 7, 6}, std::vector{0, 2, 3, 1}}) {
    solid.faces.push_back(make_face(solid.vertices, vertices, colour));
  }
  return solid;
}

Solid make_prism(const Vector3d& from_mm, const Vector3d& to_mm, double from_radius_mm, double to_radius_mm, int sides,
                 const Colour& colour) {
  const Vector3d axis = (to_mm - from_mm).normalized();
  const Vector3d across = axis.unitOrthogonal();
  const Vector3d other = axis.cross(across);
  Solid solid;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    const Vector3d out = across * std::cos(angle) + other * std::sin(angle);
    solid.vertices.push_back(from_mm + out * from_radius_mm);
    solid.vertices.push_back(to_mm + out * to_radius_mm);
  }
  std::vector<int> near_end;
  std::vector<int> far_end;
  for (int i = 0; i < sides; ++i) {
    const int next = (i + 1) % sides;
    solid.faces.push_back(make_face(solid.vertices, {2 * i, 2 * next, 2 * next + 1, 2 * i + 1}, colour));
    near_end.push_back(2 * (sides - 1 - i));
    far_end.push_back(2 * i + 1);
  }
  solid.faces.push_back(make_face(solid.vertices, near_end, colour));
  solid.faces.push_back(make_face(solid.vertices, far_end, colour));
  return solid;
}

void paint_mark(Face& face, const Vector3d& centre_mm, const Vector3d& up, Mark mark, double scale,
                const Colour& colour, int id) {
  const Vector3d right = up.cross(face.normal);
  Decal decal{{}, lit(colour, face.normal), id};
  for (const Polygon& part : mark_shape(mark)) {
    Points& points = decal.parts.emplace_back();
    for (const Vector2d& point : part)
      points.push_back(centre_mm + right * (scale * point.x()) + up * (scale * point.y()));
  }
  face.decals.push_back(std::move(decal));
}

void paint_tag(Face& face, const Vector3d& centre_mm, const Vector3d& up, const std::shared_ptr<const TagPrint>& print,
               double side_mm, const Colour& colour, int id) {
  const Vector3d right = up.cross(face.normal) * side_mm;
  const Vector3d down = -up * side_mm;
  const Vector3d corner = centre_mm - right / 2 - down / 2;
  const Points square = {corner, corner + down, corner + down + right, corner + right};
  face.decals.push_back({.parts = {square},
                         .colour = lit(colour, face.normal),
                         .id = id,
                         .cells = TagCells{print, corner, right / print->side, down / print->side}});
}

}  // namespace pizarra::simulation
