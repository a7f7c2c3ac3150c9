#include "drivers/simulation/render/seen_solid.hpp"

#include <algorithm>

namespace pizarra::simulation {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double nearest_mm = 100;  // what comes nearer to the lens is not drawn

bool shares(const std::vector<const Face*>& faces, int from, int to) {
  return std::ranges::any_of(faces, [&](const Face* face) {
    const auto& vertices = face->vertices;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      if (vertices[i] == to && vertices[(i + 1) % vertices.size()] == from) return true;
    }
    return false;
  });
}

}  // namespace

std::vector<Vector2d> see(const Eye& eye, const Points& points) {
  std::vector<Vector2d> out;
  out.reserve(points.size());
  for (const Vector3d& point : points) out.push_back(eye.project(point).head<2>());
  return out;
}

SeenSolid see(const Eye& eye, const Solid& solid) {
  SeenSolid seen;
  for (const Vector3d& vertex : solid.vertices) {
    const Vector3d at = eye.project(vertex);
    if (at.z() < nearest_mm) return {};
    seen.corners.push_back(at.head<2>());
  }
  std::vector<const Face*> turned;
  for (const Face& face : solid.faces) {
    const Vector3d& on = solid.vertices[static_cast<std::size_t>(face.vertices[0])];
    if (face.normal.dot(eye.position_mm - on) > 0) turned.push_back(&face);
  }
  std::vector<Outline::Edge> silhouette;
  for (const Face* face : turned) {
    std::vector<Outline::Edge> edges;
    std::vector<Outline::Edge> seams;
    for (std::size_t i = 0; i < face->vertices.size(); ++i) {
      const int from = face->vertices[i];
      const int to = face->vertices[(i + 1) % face->vertices.size()];
      const Vector2d& p = seen.corners[static_cast<std::size_t>(from)];
      const Vector2d& q = seen.corners[static_cast<std::size_t>(to)];
      if ((p - q).squaredNorm() < 1e-12) continue;
      // Anticlockwise seen from outside is clockwise with the image's y downwards.
      edges.push_back(Outline::edge(q, p));
      (shares(turned, from, to) ? seams : silhouette).push_back(edges.back());
    }
    SeenFace& out = seen.faces.emplace_back(
        SeenFace{Outline(std::move(edges)), Outline(std::move(seams)), face->colour, {}, {}, face->shadow_dark});
    if (face->photograph) out.photograph.emplace(eye, *face->photograph);
    for (const Points& shadow : face->shadows) out.shadows.emplace_back(see(eye, shadow));
    for (const Decal& decal : face->decals) {
      SeenDecal& seen_decal = out.decals.emplace_back(SeenDecal{{}, decal.colour, decal.id, {}});
      for (const Points& part : decal.parts) seen_decal.parts.emplace_back(see(eye, part));
      if (decal.cells) seen_decal.cells.emplace(eye, *decal.cells);
    }
  }
  seen.silhouette = Outline(std::move(silhouette));
  seen.silhouette.bound(seen.corners);
  if (!seen.faces.empty()) seen.rect = rect_around(seen.corners).intersected({0, 0, eye.width, eye.height});
  return seen;
}

}  // namespace pizarra::simulation
