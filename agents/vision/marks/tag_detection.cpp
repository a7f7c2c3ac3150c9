#include "agents/vision/marks/tag_detection.hpp"

#include <algorithm>

#include "agents/vision/marks/tag_reading.hpp"
#include "agents/vision/marks/tag_wide.hpp"

namespace pizarra::vision {
namespace {

// ArUco's larger families begin with the smaller.
constexpr TagFamily families[] = {
    {"apriltag-36h11", cv::aruco::DICT_APRILTAG_36h11},
    {"apriltag-36h10", cv::aruco::DICT_APRILTAG_36h10},
    {"apriltag-25h9", cv::aruco::DICT_APRILTAG_25h9},
    {"aruco-7x7-50", cv::aruco::DICT_7X7_50},
    {"aruco-6x6-50", cv::aruco::DICT_6X6_50},
    {"aruco-5x5-50", cv::aruco::DICT_5X5_50},
    {"aruco-4x4-50", cv::aruco::DICT_4X4_50},
    {"apriltag-16h5", cv::aruco::DICT_APRILTAG_16h5},
    {"aruco-7x7-1000", cv::aruco::DICT_7X7_1000},
    {"aruco-6x6-1000", cv::aruco::DICT_6X6_1000},
    {"aruco-5x5-1000", cv::aruco::DICT_5X5_1000},
    {"aruco-original", cv::aruco::DICT_ARUCO_ORIGINAL},
    {"aruco-4x4-1000", cv::aruco::DICT_4X4_1000},
    {"apriltag-standard41h12", {}, 2},
    {"apriltag-circle21h7", {}, 2},
    {"apriltag-standard52h13", {}, 2},
};

}  // namespace

std::span<const TagFamily> tag_families() { return families; }

const TagFamily* family_called(std::string_view name) {
  const auto found = std::ranges::find(families, name, &TagFamily::name);
  return found == std::end(families) ? nullptr : &*found;
}

int tags_of(const TagFamily& family) {
  return family.is_wide() ? wide_tags_of(family) : dictionary_of(family)->bytesList.rows;
}

cv::Ptr<cv::aruco::Dictionary> dictionary_of(const TagFamily& family) {
  return cv::aruco::getPredefinedDictionary(family.dictionary.value());
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
  parameters->cornerRefinementMethod = cv::aruco::CORNER_REFINE_SUBPIX;
  TagDetection out;
  cv::aruco::detectMarkers(grey, dictionary_of(family), out.found, out.numbers, parameters, out.others);
  read_again(grey, family, out);
  return out;
}

}  // namespace pizarra::vision
