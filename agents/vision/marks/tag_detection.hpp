#pragma once

// The squares that may be tags in an image, and those that tags of one family are, as OpenCV's detector sees them.
//
//   const TagDetection seen = detect_tags(grey, tag_families().front());
//   seen.found[0], seen.numbers[0];

#include <opencv2/aruco.hpp>
#include <span>
#include <string_view>
#include <vector>

namespace pizarra::vision {

struct TagFamily {
  std::string_view name;
  cv::aruco::PREDEFINED_DICTIONARY_NAME dictionary;
};

// Those with fewer tags and more cells first: what they say is surer.
std::span<const TagFamily> tag_families();
// Null: there is none.
const TagFamily* family_called(std::string_view name);
// How many it has: their numbers begin with 0.
int tags_of(const TagFamily& family);
// Its print, one pixel a cell, the border included: 0 dark, 255 light.
cv::Mat1b print_of(const TagFamily& family, int number);

// As OpenCV's detector has them: the share of wrong cells that may be corrected, and how long a corner is refined.
inline constexpr double mended_share = 0.6;
inline const cv::TermCriteria refined_until(cv::TermCriteria::MAX_ITER | cv::TermCriteria::EPS, 30, 0.1);

using TagCorners = std::vector<cv::Point2f>;  // clockwise from the tag's own upper left one

struct TagDetection {
  std::vector<TagCorners> found;
  std::vector<int> numbers;
  std::vector<TagCorners> others;  // squares that no tag of the family fits
};

// `least_around`: how long a square's outline is at least, as a part of the image's longer side.
TagDetection detect_tags(const cv::Mat& grey, const TagFamily& family, double least_around = 0.03);

}  // namespace pizarra::vision
