#pragma once

// Squares that OpenCV's detector saw and could not read, read once more. It puts their corners on whole pixels, which
// is too far off for cells some three pixels wide, and takes one level of grey between light and dark, which a shadow's
// edge across the tag does not leave.
//
//   TagDetection seen = ...;
//   read_again(grey, family, seen);          // seen.found has more, seen.others less
//
// Corners are refined first. What is light and what is dark is a plane each, by the cells of the border and by what is
// around it (E. Olson, AprilTag: a robust and flexible visual fiducial system, ICRA 2011). Then the print is fitted to
// the image, and the corners are taken that make both likest.

#include "agents/vision/marks/tag_detection.hpp"

namespace pizarra::vision {

// More is asked of these squares than of others: light around them, and cells that are like the print.
void read_again(const cv::Mat1b& grey, const TagFamily& family, TagDetection& detection);

}  // namespace pizarra::vision
