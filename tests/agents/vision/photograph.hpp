#pragma once

// Photographs of a printed sheet, as a phone or a webcam takes them: perspective, uneven light and a shadow, blur,
// sensor noise, JPEG. Drawn by the benches' exact outlines; nothing of the cell's renderer is in them.
//
//   Photograph photograph{.size = {1280, 960}, .tilt_deg = 15};
//   cv::Mat3b seen = photograph.take(random);
//   photograph.seen_at("circle");                         // its centroid, px

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "blackboard/time/random.hpp"

namespace pizarra::vision {

struct PrintedShape {
  std::string name;
  cv::Point2d at_mm;
  double scale = 1;
  double turn_deg = 0;
};

// circle, triangle, square and cross of 44 mm, 90 by 60 mm apart.
const std::vector<PrintedShape>& printed_shapes();

struct Photograph {
  cv::Size size{640, 480};
  double tilt_deg = 0;  // of the sheet, its upper edge away
  double pan_deg = 0;   // its right edge away
  double roll_deg = 0;
  double distance_mm = 500;
  double light = 0.9;          // at the middle; the left is brighter, the corners are darker
  double slope = 0.5;          // part of the light from one edge to the other
  double shadow = 0.75;        // of the light, on the lower left
  bool light_on_dark = false;  // the sheet's shapes
  bool cluttered = false;      // a keyboard beside the sheet, two fingers on its edge
  double blur_px = 1;
  double noise = 4;  // grey levels
  int jpeg_quality = 80;
  cv::Point2d aside_mm{};  // of the sheet, in the picture
  std::vector<PrintedShape> shapes = printed_shapes();

  double focal_px() const { return 0.87 * size.width; }
  // Where a point of the sheet is seen, mm from its middle, x right, y down; and how far away it is.
  cv::Point2d project(cv::Point2d sheet_mm) const;
  double range_mm(cv::Point2d sheet_mm) const;
  cv::Point2d seen_at(const std::string& shape) const;

  cv::Mat3b take(Random& random) const;
};

}  // namespace pizarra::vision
