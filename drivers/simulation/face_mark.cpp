#include "drivers/simulation/face_mark.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <opencv2/aruco.hpp>

namespace pizarra::simulation {

namespace {

constexpr std::array<std::string_view, 12> names_of_marks = {"circle",   "square",    "cross",    "triangle",
                                                             "arrow",    "hourglass", "house",    "star",
                                                             "letter-h", "letter-t",  "letter-y", "letter-z"};

constexpr std::array<std::string_view, 6> names_of_faces = {"front", "back", "right", "left", "top", "bottom"};

struct PrintedFamily {
  std::string_view name;
  cv::aruco::PREDEFINED_DICTIONARY_NAME dictionary;
};

constexpr PrintedFamily printed_families[] = {
    {"apriltag-36h11", cv::aruco::DICT_APRILTAG_36h11}, {"apriltag-36h10", cv::aruco::DICT_APRILTAG_36h10},
    {"apriltag-25h9", cv::aruco::DICT_APRILTAG_25h9},   {"apriltag-16h5", cv::aruco::DICT_APRILTAG_16h5},
    {"aruco-4x4-50", cv::aruco::DICT_4X4_50},           {"aruco-4x4-1000", cv::aruco::DICT_4X4_1000},
    {"aruco-5x5-50", cv::aruco::DICT_5X5_50},           {"aruco-5x5-1000", cv::aruco::DICT_5X5_1000},
    {"aruco-6x6-50", cv::aruco::DICT_6X6_50},           {"aruco-6x6-1000", cv::aruco::DICT_6X6_1000},
    {"aruco-7x7-50", cv::aruco::DICT_7X7_50},           {"aruco-7x7-1000", cv::aruco::DICT_7X7_1000},
    {"aruco-original", cv::aruco::DICT_ARUCO_ORIGINAL},
};

// The number as it is written, without a sign or a leading zero.
std::optional<int> number_from(std::string_view digits) {
  int number = 0;
  const char* const end = digits.data() + digits.size();
  const auto [read_to, error] = std::from_chars(digits.data(), end, number);
  if (error != std::errc() || read_to != end || std::to_string(number) != digits || number < 0) return std::nullopt;
  return number;
}

std::optional<TagMark> tag_from_name(std::string_view name) {
  const std::size_t dash = name.rfind('-');
  if (dash == std::string_view::npos) return std::nullopt;
  const auto* const family = std::ranges::find(printed_families, name.substr(0, dash), &PrintedFamily::name);
  const std::optional<int> number = number_from(name.substr(dash + 1));
  if (family == std::end(printed_families) || !number) return std::nullopt;
  const cv::Ptr<cv::aruco::Dictionary> dictionary = cv::aruco::getPredefinedDictionary(family->dictionary);
  if (*number >= dictionary->bytesList.rows) return std::nullopt;
  cv::Mat1b cells;  // one pixel a cell
  dictionary->drawMarker(*number, dictionary->markerSize + 2, cells);
  TagPrint print{.side = cells.cols, .light = {}};
  for (const std::uint8_t level : cells) print.light.push_back(level > 0);
  return TagMark{std::string(name), std::make_shared<const TagPrint>(std::move(print))};
}

}  // namespace

std::optional<Mark> mark_from_name(std::string_view name) {
  const auto found = std::ranges::find(names_of_marks, name);
  if (found == names_of_marks.end()) return std::nullopt;
  return static_cast<Mark>(found - names_of_marks.begin());
}

std::string_view mark_name(Mark mark) { return names_of_marks[static_cast<std::size_t>(mark)]; }

std::span<const std::string_view> mark_names() { return names_of_marks; }

std::optional<FaceMark> face_mark_from_name(std::string_view name) {
  const std::optional<Mark> shape = mark_from_name(name);
  if (shape) return *shape;
  return tag_from_name(name);
}

std::optional<CubeFace> cube_face_from_name(std::string_view name) {
  const auto* const found = std::ranges::find(names_of_faces, name);
  if (found == names_of_faces.end()) return std::nullopt;
  return static_cast<CubeFace>(found - names_of_faces.begin());
}

CubeMarks on_each_face(const FaceMark& mark) {
  CubeMarks out;
  out.fill(mark);
  return out;
}

std::string face_mark_name(const FaceMark& mark) {
  const TagMark* tag = std::get_if<TagMark>(&mark);
  return tag != nullptr ? tag->name : std::string(mark_name(std::get<Mark>(mark)));
}

}  // namespace pizarra::simulation
