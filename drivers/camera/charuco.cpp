#include "drivers/camera/charuco.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <opencv2/aruco/charuco.hpp>
#include <opencv2/imgproc.hpp>

namespace pizarra::camera {
namespace {

// In an image that is no wider the tags are sought in one twice as large: their cells may be two pixels wide.
constexpr int small_image_px = 1000;

// Corners by their number on the board, row by row.
using Numbered = std::map<std::size_t, cv::Point2f>;

cv::Ptr<cv::aruco::CharucoBoard> made(const CalibrationBoard& board) {
  return cv::aruco::CharucoBoard::create(board.columns + 1, board.rows + 1, static_cast<float>(board.square_mm),
                                         static_cast<float>(board.tags->side_mm),
                                         cv::aruco::getPredefinedDictionary(board.tags->dictionary));
}

struct Found {
  std::size_t tags = 0;
  Numbered corners;
};

using TagCorners = std::vector<std::vector<cv::Point2f>>;

// Tags of the family may lie about that are none of the board's, whose numbers begin with 0.
void keep_tags_of(const cv::aruco::CharucoBoard& board, TagCorners& tags, std::vector<int>& numbers) {
  for (std::size_t i = tags.size(); i-- > 0;) {
    if (static_cast<std::size_t>(numbers[i]) < board.ids.size()) continue;
    tags.erase(tags.begin() + static_cast<std::ptrdiff_t>(i));
    numbers.erase(numbers.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

void scale_back(TagCorners& tags, int larger) {
  const auto factor = static_cast<float>(larger);
  for (std::vector<cv::Point2f>& tag : tags) {
    // The middle of the first pixel is half a pixel from the edge, in both.
    for (cv::Point2f& at : tag) at = (at + cv::Point2f(0.5F, 0.5F)) / factor - cv::Point2f(0.5F, 0.5F);
  }
}

Found find_in(const cv::Mat& image, const cv::Ptr<cv::aruco::CharucoBoard>& board) {
  cv::Mat grey = image;
  if (image.channels() == 3) cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  TagCorners tags;
  TagCorners others;
  std::vector<int> numbers;
  const int larger = grey.cols <= small_image_px ? 2 : 1;
  cv::Mat looked_at;
  cv::resize(grey, looked_at, {}, larger, larger, cv::INTER_CUBIC);
  cv::aruco::detectMarkers(looked_at, board->dictionary, tags, numbers, cv::aruco::DetectorParameters::create(),
                           others);
  keep_tags_of(*board, tags, numbers);
  Found out{.tags = tags.size(), .corners = {}};
  if (tags.empty()) return out;
  cv::aruco::refineDetectedMarkers(looked_at, board, tags, numbers, others);
  scale_back(tags, larger);
  std::vector<cv::Point2f> corners;
  std::vector<int> which;
  cv::aruco::interpolateCornersCharuco(tags, numbers, grey, board, corners, which);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    out.corners.emplace(static_cast<std::size_t>(which[i]), corners[i]);
  }
  return out;
}

// Those of a single row, or of one row and a corner more, fit many places.
bool span_the_board(const Numbered& corners, const CalibrationBoard& board) {
  std::map<std::size_t, int> in_row;
  for (const auto& [number, at] : corners) ++in_row[number / static_cast<std::size_t>(board.columns)];
  return std::ranges::count_if(in_row, [](const auto& row) { return row.second >= 2; }) >= 2;
}

Result<void> check(const Found& found, const CalibrationBoard& board, const std::string& where) {
  if (found.tags == 0) {
    const int tags = (board.columns + 1) * (board.rows + 1) / 2;
    return fail("no-board", fmt::format("no ChArUco board{}: there is no tag of {} with a number below {}", where,
                                        board.tags->family, tags));
  }
  if (found.corners.size() >= least_charuco_corners && span_the_board(found.corners, board)) return {};
  return fail("no-board", fmt::format("too few corners of the ChArUco board{}: {} of {} x {}, where {} in two rows are "
                                      "the least",
                                      where, found.corners.size(), board.columns, board.rows, least_charuco_corners));
}

void keep_common(Numbered& corners, const Numbered& others) {
  std::erase_if(corners, [&](const auto& corner) { return !others.contains(corner.first); });
}

std::vector<cv::Point2f> places_of(const Numbered& corners) {
  std::vector<cv::Point2f> out;
  for (const auto& [number, at] : corners) out.push_back(at);
  return out;
}

}  // namespace

Result<BoardView> find_charuco(const cv::Mat& left, const cv::Mat& right, const CalibrationBoard& board) {
  const cv::Ptr<cv::aruco::CharucoBoard> charuco = made(board);
  const bool single = right.empty();
  Found in_left = find_in(left, charuco);
  const Result<void> left_checked = check(in_left, board, single ? "" : " in the left image");
  if (!left_checked) return fail(left_checked);
  BoardView out;
  if (!single) {
    Found in_right = find_in(right, charuco);
    const Result<void> right_checked = check(in_right, board, " in the right image");
    if (!right_checked) return fail(right_checked);
    keep_common(in_left.corners, in_right.corners);
    keep_common(in_right.corners, in_left.corners);
    const Result<void> checked = check(in_left, board, " in both images at once");
    if (!checked) return fail(checked);
    out.right = places_of(in_right.corners);
  }
  out.left = places_of(in_left.corners);
  for (const auto& [number, at] : in_left.corners) out.which.push_back(number);
  return out;
}

std::vector<PlacedTag> tags_on(const CalibrationBoard& board) {
  const cv::Ptr<cv::aruco::CharucoBoard> charuco = made(board);
  std::vector<PlacedTag> out;
  for (std::size_t i = 0; i < charuco->ids.size(); ++i) {
    const cv::Point3f& corner = charuco->objPoints[i].front();
    out.push_back({charuco->ids[i], {corner.x, corner.y}});
  }
  return out;
}

}  // namespace pizarra::camera
