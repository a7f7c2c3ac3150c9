#pragma once

// The squares that may be tags in an image, and those that tags of one family are. Most families are read by OpenCV's
// detector. Those whose square is light, with more cells around it, are read by libapriltag's (tag_wide.hpp).
//
//   const TagDetection seen = detect_tags(grey, tag_families().front());
//   seen.found[0], seen.numbers[0];

#include <opencv2/aruco.hpp>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace pizarra::vision {

struct TagFamily {
  std::string_view name;
  std::optional<cv::aruco::PREDEFINED_DICTIONARY_NAME> dictionary;  // of those that OpenCV reads
  // Cells beyond the square, on each side. The square is the one whose corners are the tag's, and whose side is the
  // tag's side. Where there are such cells it is light within a dark line; else it is dark on light ground.
  int cells_around = 0;
  // Any two of its tags differ in so many cells at least, where OpenCV does not say how many it may mend.
  int cells_apart = 0;

  bool is_wide() const { return cells_around > 0; }
};

// Those with fewer tags and more cells first: what they say is surer. The wide ones last.
std::span<const TagFamily> tag_families();
// Null: there is none.
const TagFamily* family_called(std::string_view name);
// How many it has: their numbers begin with 0.
int tags_of(const TagFamily& family);
// A cell of a print that is neither dark nor light: nothing is printed there.
inline constexpr std::uint8_t unprinted = 128;
// Its print, one pixel a cell, the border and the cells around the square included: 0 dark, 255 light.
cv::Mat1b print_of(const TagFamily& family, int number);
// That which OpenCV reads the family with.
cv::Ptr<cv::aruco::Dictionary> dictionary_of(const TagFamily& family);

// As OpenCV's detector has them: the share of wrong cells that may be corrected, and how long a corner is refined.
inline constexpr double mended_share = 0.6;
inline const cv::TermCriteria refined_until(cv::TermCriteria::MAX_ITER | cv::TermCriteria::EPS, 30, 0.1);

using TagCorners = std::vector<cv::Point2f>;  // clockwise from the tag's own upper left one

struct TagDetection {
  std::vector<TagCorners> found;
  std::vector<int> numbers;
  std::vector<TagCorners> others;  // squares that no tag of the family fits; none of a wide family
};

// Whether a tag was read where the middle of these corners is.
bool is_read(const TagDetection& detection, const TagCorners& corners);

// `least_around`: how long a square's outline is at least, as a part of the image's longer side; not for wide ones.
TagDetection detect_tags(const cv::Mat& grey, const TagFamily& family, double least_around = 0.03);
// With those across which the edge of a shadow falls, among these squares too (squares_at_levels()).
TagDetection detect_all_tags(const cv::Mat& grey, const TagFamily& family, std::span<const TagCorners> squares);

}  // namespace pizarra::vision
