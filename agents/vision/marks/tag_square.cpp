#include "agents/vision/marks/tag_square.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "agents/vision/marks/tag_detection.hpp"

namespace pizarra::vision {
namespace {

using Corners = std::vector<cv::Point2f>;

// Smaller ones can hardly be read.
constexpr double least_side_px = 8;
// How far a side may be off a straight line, as a part of the circumference; as much as for OpenCV's detector.
constexpr double straightness = 0.03;
constexpr int least_refined_px = 2;
constexpr int most_refined_px = 5;

std::vector<Corners> squares_of(const cv::Mat1b& dark, cv::RetrievalModes which) {
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(dark, contours, which, cv::CHAIN_APPROX_NONE);
  std::vector<Corners> out;
  for (const std::vector<cv::Point>& contour : contours) {
    const auto around = static_cast<double>(contour.size());
    if (around < 4 * least_side_px) continue;
    std::vector<cv::Point> corners;
    cv::approxPolyDP(contour, corners, straightness * around, true);
    const bool is_hole = cv::contourArea(corners, true) > 0;
    if (corners.size() != 4 || is_hole || !cv::isContourConvex(corners)) continue;
    out.emplace_back(corners.rbegin(), corners.rend());
  }
  return out;
}

std::vector<Corners> dark_squares(const cv::Mat1b& grey) {
  cv::Mat1b dark;
  cv::threshold(grey, dark, 0, 255, cv::THRESH_BINARY_INV | cv::THRESH_OTSU);
  return squares_of(dark, cv::RETR_EXTERNAL);
}

// One where a cell is light.
cv::Mat1b cells_of(const cv::Mat1b& grey, const Corners& corners, int cells) {
  constexpr int cell_px = 4;
  cv::Mat1b out;
  cv::resize(squared(grey, corners, cells * cell_px), out, {cells, cells}, 0, 0, cv::INTER_AREA);
  cv::threshold(out, out, 0, 1, cv::THRESH_BINARY | cv::THRESH_OTSU);
  return out;
}

}  // namespace

Corners refined(const cv::Mat1b& grey, Corners corners, int cells) {
  double shortest = cv::norm(corners.front() - corners.back());
  for (std::size_t i = 1; i < corners.size(); ++i) shortest = std::min(shortest, cv::norm(corners[i] - corners[i - 1]));
  const int within = std::clamp(cvRound(shortest / cells), least_refined_px, most_refined_px);
  cv::cornerSubPix(grey, corners, {within, within}, {-1, -1}, refined_until);
  return corners;
}

std::vector<Corners> squares_at_levels(const cv::Mat1b& grey) {
  constexpr double least_level = 16;
  constexpr double most_level = 220;
  constexpr double apart = 1.25;
  std::vector<Corners> out;
  for (double level = least_level; level < most_level; level *= apart) {
    const cv::Mat1b dark = grey < level;
    for (Corners& corners : squares_of(dark, cv::RETR_LIST)) out.push_back(std::move(corners));
  }
  return out;
}

std::vector<TagSquare> tags_at_a_glance(const cv::Mat1b& grey, const cv::Rect& area,
                                        const cv::aruco::Dictionary& dictionary) {
  const int across = dictionary.markerSize;
  std::vector<TagSquare> out;
  for (Corners& corners : dark_squares(grey(area))) {
    for (cv::Point2f& corner : corners) corner += cv::Point2f(area.tl());
    corners = refined(grey, std::move(corners), across + 2);
    const cv::Mat1b cells = cells_of(grey, corners, across + 2);
    const cv::Mat1b inner = cells(cv::Rect(1, 1, across, across)).clone();
    const bool dark_border = cv::countNonZero(cells) == cv::countNonZero(inner);
    int number = 0;
    int quarter_turns = 0;
    if (!dark_border || !dictionary.identify(inner, number, quarter_turns, mended_share)) continue;
    std::ranges::rotate(corners, corners.begin() + (4 - quarter_turns) % 4);
    out.push_back({number, std::move(corners)});
  }
  return out;
}

cv::Mat1b squared(const cv::Mat1b& grey, const std::vector<cv::Point2f>& corners, int side_px, int around_px) {
  const float begin = static_cast<float>(around_px) - 0.5F;
  const float end = static_cast<float>(side_px - around_px) - 0.5F;
  const Corners square = {{begin, begin}, {end, begin}, {end, end}, {begin, end}};
  cv::Mat1b out;
  cv::warpPerspective(grey, out, cv::getPerspectiveTransform(square, corners), {side_px, side_px},
                      cv::INTER_LINEAR | cv::WARP_INVERSE_MAP, cv::BORDER_REPLICATE);
  return out;
}

cv::Mat1f cell_levels(const cv::Mat1b& square, int cells) {
  constexpr int edge_px = 1;
  const int cell_px = square.cols / cells;
  cv::Mat1f out(cells, cells);
  for (int y = 0; y < cells; ++y) {
    for (int x = 0; x < cells; ++x) {
      const cv::Rect cell(x * cell_px, y * cell_px, cell_px, cell_px);
      const cv::Rect middle = cell + cv::Point(edge_px, edge_px) - cv::Size(2 * edge_px, 2 * edge_px);
      out(y, x) = static_cast<float>(cv::mean(square(middle))[0]);
    }
  }
  return out;
}

}  // namespace pizarra::vision
