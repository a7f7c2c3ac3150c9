#pragma once

// Shapes of test scenes as closed outlines, and their exact area coverage of pixels. Nothing here is shared with the
// cell's renderer or with the eyes.
//
//   Shape shape = mark_shape("triangle");                     // mm around its centroid
//   paint(image, placed(shape, {160.3, 88.7}, 0.5, 12), 30);  // 0.5 px a mm, turned by 12 degrees, reflecting 30

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "blackboard/time/random.hpp"

namespace pizarra::bench {

using Outline = std::vector<cv::Point2d>;
// Filled; an outline that runs the other way round within another is a hole. y points down.
using Shape = std::vector<Outline>;

// circle, square, cross, triangle: 44 mm across, around the centroid. plate: what bears the end-effector's triangle.
Shape mark_shape(const std::string& name);
Shape disc(double radius);
Shape box(double width, double height);
// The dark cells (non-zero) of a square tag `size` across, border included.
Shape tag_shape(const cv::Mat1b& dark_cells, double size);

// Moved to `centre` after being scaled and turned (degrees, clockwise as seen).
Shape placed(const Shape& shape, cv::Point2d centre, double scale, double turn_deg);

// Each pixel becomes a mixture of itself and `value` by how much of it the shape covers. Pixel (0, 0) reaches from -0.5
// to 0.5. Outlines of one shape do not cross one another.
void paint(cv::Mat1f& image, const Shape& shape, float value);

}  // namespace pizarra::bench
