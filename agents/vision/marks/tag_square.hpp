#pragma once

// The squares of tags where one is known to be about: by one threshold for all that is looked at, which is enough for a
// small area in even light, in a fraction of the time of OpenCV's detector, which sees more.
//
//   for (const TagSquare& square : tags_at_a_glance(grey, area, *dictionary)) square.number;

#include <opencv2/aruco.hpp>
#include <opencv2/core.hpp>
#include <vector>

namespace pizarra::vision {

struct TagSquare {
  int number;
  std::vector<cv::Point2f> corners;  // clockwise from the tag's own upper left one
};

// `area`: within the image.
std::vector<TagSquare> tags_at_a_glance(const cv::Mat1b& grey, const cv::Rect& area,
                                        const cv::aruco::Dictionary& dictionary);

// The image between the corners and around them, as a square so many pixels wide: the corners are `around_px` within
// it.
cv::Mat1b squared(const cv::Mat1b& grey, const std::vector<cv::Point2f>& corners, int side_px, int around_px = 0);

}  // namespace pizarra::vision
