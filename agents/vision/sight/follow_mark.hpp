#pragma once

// The interline idea: a mark that was seen is followed from where its motion predicts its centre, outwards to its
// contour, and little of the image need be looked at.
//
//   std::optional<SeenMark> now = follow_mark(sight.left(), sight.noise(), last, expected);

#include <optional>

#include "agents/vision/marks/mark_measure.hpp"

namespace pizarra::vision {

// Converts px of an image 320 px wide into px of this one.
double px_in(const cv::Mat& image, double px);

// The mark that was `last`, near `centre`. Nothing where no closed contour of its tone is around that.
std::optional<SeenMark> follow_mark(const cv::Mat& grey, double noise, const SeenMark& last, cv::Point2d centre);

}  // namespace pizarra::vision
