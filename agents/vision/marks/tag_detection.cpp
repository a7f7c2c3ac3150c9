#include "agents/vision/marks/tag_detection.hpp"

#include <algorithm>
#include <functional>
#include <opencv2/imgproc.hpp>

#include "agents/vision/marks/tag_mark.hpp"
#include "agents/vision/marks/tag_reading.hpp"
#include "agents/vision/marks/tag_square.hpp"
#include "agents/vision/marks/tag_wide.hpp"

namespace pizarra::vision {
namespace {

// ArUco's larger families begin with the smaller.
constexpr TagFamily families[] = {
    {"apriltag-36h11", cv::aruco::DICT_APRILTAG_36h11, 0, 11},
    {"apriltag-36h10", cv::aruco::DICT_APRILTAG_36h10, 0, 10},
    {"apriltag-25h9", cv::aruco::DICT_APRILTAG_25h9, 0, 9},
    {"aruco-7x7-50", cv::aruco::DICT_7X7_50},
    {"aruco-6x6-50", cv::aruco::DICT_6X6_50},
    {"aruco-5x5-50", cv::aruco::DICT_5X5_50},
    {"aruco-4x4-50", cv::aruco::DICT_4X4_50},
    {"apriltag-16h5", cv::aruco::DICT_APRILTAG_16h5, 0, 5},
    {"aruco-7x7-1000", cv::aruco::DICT_7X7_1000},
    {"aruco-6x6-1000", cv::aruco::DICT_6X6_1000},
    {"aruco-5x5-1000", cv::aruco::DICT_5X5_1000},
    {"aruco-original", cv::aruco::DICT_ARUCO_ORIGINAL},
    {"aruco-4x4-1000", cv::aruco::DICT_4X4_1000},
    {"apriltag-standard41h12", {}, 2},
    {"apriltag-circle21h7", {}, 2},
    {"apriltag-standard52h13", {}, 2},
};

// Where no tag was read yet, each once, the largest first.
std::vector<TagCorners> unread_squares(const cv::Mat1b& grey, const TagFamily& family,
                                       std::span<const TagCorners> squares, const TagDetection& read) {
  constexpr std::size_t most_squares = 256;
  constexpr double same_px = 1.5;
  std::vector<TagCorners> out;
  for (const TagCorners& square : squares) {
    const auto is_it = [&](const TagCorners& other) { return cv::norm(square, other, cv::NORM_INF) < same_px; };
    if (is_read(read, square) || !has_a_border(grey, square, family) || std::ranges::any_of(out, is_it)) continue;
    out.push_back(square);
  }
  std::ranges::stable_sort(out, std::greater<>(), [](const TagCorners& square) { return cv::contourArea(square); });
  if (out.size() > most_squares) out.resize(most_squares);
  return out;
}

}  // namespace

bool is_read(const TagDetection& detection, const TagCorners& corners) {
  const cv::Point2f middle = (corners[0] + corners[1] + corners[2] + corners[3]) / 4;
  return std::ranges::any_of(detection.found,
                             [&](const TagCorners& other) { return cv::pointPolygonTest(other, middle, false) >= 0; });
}

std::span<const TagFamily> tag_families() { return families; }

const TagFamily* family_called(std::string_view name) {
  const auto found = std::ranges::find(families, name, &TagFamily::name);
  return found == std::end(families) ? nullptr : &*found;
}

int tags_of(const TagFamily& family) {
  return family.is_wide() ? wide_tags_of(family) : dictionary_of(family)->bytesList.rows;
}

cv::Ptr<cv::aruco::Dictionary> dictionary_of(const TagFamily& family) {
  cv::Ptr<cv::aruco::Dictionary> out = cv::aruco::getPredefinedDictionary(family.dictionary.value());
  if (family.cells_apart > 0) out->maxCorrectionBits = (family.cells_apart - 1) / 2;
  return out;
}

cv::Mat1b print_of(const TagFamily& family, int number) {
  if (family.is_wide()) return wide_print(family, number);
  const cv::Ptr<cv::aruco::Dictionary> dictionary = dictionary_of(family);
  cv::Mat out;
  dictionary->drawMarker(number, dictionary->markerSize + 2, out);
  return out;
}

TagDetection detect_tags(const cv::Mat& grey, const TagFamily& family, double least_around) {
  if (family.is_wide()) return detect_wide_tags(grey, family);
  const auto parameters = cv::aruco::DetectorParameters::create();
  parameters->minMarkerPerimeterRate = least_around;
  parameters->cornerRefinementMethod = cv::aruco::CORNER_REFINE_NONE;
  TagDetection out;
  const cv::Ptr<cv::aruco::Dictionary> dictionary = dictionary_of(family);
  cv::aruco::detectMarkers(grey, dictionary, out.found, out.numbers, parameters, out.others);
  for (TagCorners& corners : out.found) corners = refined(grey, std::move(corners), dictionary->markerSize + 2);
  read_again(grey, family, out);
  return out;
}

TagDetection detect_all_tags(const cv::Mat& grey, const TagFamily& family, std::span<const TagCorners> squares) {
  TagDetection out = detect_tags(grey, family);
  if (family.is_wide()) return out;
  out.others = unread_squares(grey, family, squares, out);
  read_again(grey, family, out);
  fit_again(grey, family, out);
  return out;
}

}  // namespace pizarra::vision
