#pragma once

// The things that are drawn: convex solids with flat faces, and convex decals painted on them.
//
//   Solid cube = make_box(pose, {0, 0, 0}, {30, 30, 30}, white);
//   paint_mark(cube.faces[0], centre, up, Mark::circle, 1, black, id);
//   paint_tag(cube.faces[2], centre, up, tag.print, 48, black, id);

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <vector>

#include "drivers/simulation/photograph.hpp"
#include "drivers/simulation/render/mark_shape.hpp"

namespace pizarra::simulation {

using Colour = Eigen::Vector3f;  // blue, green, red; 0..255
using Points = std::vector<Eigen::Vector3d>;

// Where the cells of a tag lie in the base frame. Its light ones have the colour of the face.
struct TagCells {
  std::shared_ptr<const TagPrint> print;
  Eigen::Vector3d corner_mm;  // the upper left one of its print
  Eigen::Vector3d right_mm;   // a cell to the right
  Eigen::Vector3d down_mm;    // a cell down
};

struct Decal {
  std::vector<Points> parts;  // convex polygons in the face's plane; they may overlap
  Colour colour;
  int id = 0;  // above 0 for marks that the truth asks about
  std::optional<TagCells> cells = {};
};

struct Face {
  std::vector<int> vertices;  // anticlockwise seen from outside
  Eigen::Vector3d normal;
  Colour colour;  // with the light on it
  std::vector<Decal> decals;
  // Hard, convex, within the face; each takes this part of its light, and several no more than one.
  std::vector<Points> shadows = {};
  float shadow_dark = 0;
  std::optional<LaidPhotograph> photograph = {};  // over all of it, under decals and shadows
};

struct Solid {
  Points vertices;
  std::vector<Face> faces;
};

// How a surface of this colour looks under the cell's lamp when it faces along `normal`.
Colour lit(const Colour& colour, const Eigen::Vector3d& normal);
// Where the lamp stands, as a direction.
Eigen::Vector3d lamp();

// Faces in the order +x -x +y -y +z -z of `pose`.
Solid make_box(const Eigen::Isometry3d& pose, const Eigen::Vector3d& centre_mm, const Eigen::Vector3d& half_mm,
               const Colour& colour);
// A round thing of `sides` flat sides between two centres; the last two faces are its ends.
Solid make_prism(const Eigen::Vector3d& from_mm, const Eigen::Vector3d& to_mm, double from_radius_mm,
                 double to_radius_mm, int sides, const Colour& colour);

// Paints the mark, `scale` times its size, on a face's plane; `centre_mm` in the base frame, `up` the mark's upward
// direction in the plane.
void paint_mark(Face& face, const Eigen::Vector3d& centre_mm, const Eigen::Vector3d& up, Mark mark, double scale,
                const Colour& colour, int id);
// Paints a tag whose dark square has sides of `side_mm`.
void paint_tag(Face& face, const Eigen::Vector3d& centre_mm, const Eigen::Vector3d& up,
               const std::shared_ptr<const TagPrint>& print, double side_mm, const Colour& colour, int id);

}  // namespace pizarra::simulation
