#pragma once

// Reads squares once more that OpenCV's detector saw and could not read. The detector puts corners on whole pixels,
// which is too coarse where a cell is some three pixels wide. It also splits light from dark by one level of grey. That
// level need not fit where the edge of a shadow crosses the tag.
//
//   TagDetection seen = ...;
//   read_again(grey, family, seen);          // seen.found has more, seen.others less
//   fit_again(grey, family, seen);           // seen.found has better corners
//
// Corners are refined first. Light and dark are one plane of grey each, fitted to the ground around the tag and to the
// cells of its border (E. Olson, AprilTag: a robust and flexible visual fiducial system, ICRA 2011), or are split by a
// level between the two. Then the print is fitted to the image. The corners are kept at which the image is most like
// the print.

#include "agents/vision/marks/tag_detection.hpp"

namespace pizarra::vision {

// More is asked of these squares than of others: light around them, and cells that are like the print.
void read_again(const cv::Mat1b& grey, const TagFamily& family, TagDetection& detection);

// Where something beside a tag pulls its corners off, a shadow's edge, those at which the image is most like the print.
void fit_again(const cv::Mat1b& grey, const TagFamily& family, TagDetection& detection);

}  // namespace pizarra::vision
