#pragma once

// The part of each mark that an eye can see: for the judge and the scripted person, never for a picture.
//
//   const std::vector<MarkView> marks = seen_marks(eye, scene.solids);

#include "drivers/simulation/render/seen_solid.hpp"

namespace pizarra::simulation {

struct MarkView {
  int id = 0;
  int pixels = 0;  // that show it
  // That would show it if nothing were in front and the image had no border, with those that the border cuts off of the
  // face around it: without these no eyes recognise it.
  int all_pixels = 0;
  Eigen::Vector2d centre_px = Eigen::Vector2d::Zero();  // its centroid as it would be seen then
};

// Every mark on a face that is turned to the eye.
std::vector<MarkView> seen_marks(const Eye& eye, const std::vector<Solid>& solids);

}  // namespace pizarra::simulation
