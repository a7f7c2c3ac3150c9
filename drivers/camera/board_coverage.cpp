#include "drivers/camera/board_coverage.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <opencv2/calib3d.hpp>

#include "drivers/camera/fit_checks.hpp"

namespace pizarra::camera {
namespace {

constexpr int parts = 3;  // each way
constexpr std::array<const char*, parts* parts> part_names = {
    "top left", "top", "top right", "left", "middle", "right", "bottom left", "bottom", "bottom right"};
// Of most cameras that nobody has calibrated yet, of the image's width.
constexpr double usual_focal = 0.87;

using CornersOf = std::vector<cv::Point2f> BoardView::*;

bool is_reached(const std::vector<BoardView>& views, CornersOf side, const cv::Rect2f& part) {
  return std::ranges::any_of(views, [&](const BoardView& view) {
    return std::ranges::any_of(view.*side, [&](const cv::Point2f& corner) { return part.contains(corner); });
  });
}

void add_unreached(std::vector<Lack>& lacks, const std::vector<BoardView>& views, cv::Size image, bool right_image,
                   const std::string& of) {
  const cv::Size2f size(static_cast<float>(image.width) / parts, static_cast<float>(image.height) / parts);
  for (int i = 0; i < parts * parts; ++i) {
    const int column = i % parts;
    const int row = i / parts;
    const cv::Rect2f part({static_cast<float>(column) * size.width, static_cast<float>(row) * size.height}, size);
    if (is_reached(views, right_image ? &BoardView::right : &BoardView::left, part)) continue;
    const char* const name = part_names[static_cast<std::size_t>(i)];
    lacks.push_back(
        {fmt::format("bring the board to the {} of the {}", name, of), Lack::Part{right_image, column, row}});
  }
}

// How the boards stand, seen by a usual camera; the tilts differ little with the focal length.
std::vector<cv::Mat> turns_of(const std::vector<BoardView>& views, cv::Size image, const CalibrationBoard& board) {
  const double focal_px = usual_focal * image.width;
  const cv::Matx33d camera(focal_px, 0, image.width / 2.0, 0, focal_px, image.height / 2.0, 0, 0, 1);
  std::vector<cv::Mat> out;
  for (const BoardView& view : views) {
    cv::Mat turn;
    cv::Mat unused;
    if (cv::solvePnP(corners_of(view, board), view.left, camera, cv::noArray(), turn, unused)) out.push_back(turn);
  }
  return out;
}

}  // namespace

std::vector<Lack> lacks_of(const std::vector<BoardView>& views, cv::Size image, const CalibrationBoard& board) {
  std::vector<Lack> out;
  if (views.empty()) return {{"hold the board before the camera, whole and flat"}};
  const bool single = views.front().right.empty();
  if (tilts_deg(turns_of(views, image, board)) < least_tilts_deg) {
    out.push_back({"tilt the board, by up to 45 degrees each way"});
  }
  add_unreached(out, views, image, false, single ? "image" : "left image");
  if (!single) add_unreached(out, views, image, true, "right image");
  return out;
}

}  // namespace pizarra::camera
