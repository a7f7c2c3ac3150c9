#include "agents/vision/marks/tag_reading.hpp"

#include <algorithm>
#include <functional>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "agents/vision/marks/tag_fit.hpp"
#include "agents/vision/marks/tag_mark.hpp"
#include "agents/vision/marks/tag_square.hpp"

namespace pizarra::vision {
namespace {

constexpr double least_cell_px = 2;
// This share of the border's cells may look light.
constexpr double most_light_share = 0.1;
// How often the print is fitted.
constexpr int most_fits = 2;

// The grey levels of a tag's cells, its border and the ring of ground around it, one pixel a cell.
cv::Mat1f levels_of(const cv::Mat1b& grey, const TagCorners& corners, int cells) {
  constexpr int cell_px = 4;
  return cell_levels(squared(grey, corners, (cells + 2) * cell_px, cell_px), cells + 2);
}

// Visits the ring of cells that are `from_edge` cells away from the edge.
template <class Visit>
void visit_ring(const cv::Mat1f& levels, int from_edge, const Visit& visit) {
  const int last = levels.cols - 1 - from_edge;
  for (int i = from_edge; i < last; ++i) {
    visit(cv::Point(i, from_edge));
    visit(cv::Point(last, i));
    visit(cv::Point(levels.cols - 1 - i, last));
    visit(cv::Point(from_edge, levels.cols - 1 - i));
  }
}

cv::Vec3d row_at(cv::Point cell) { return {1, static_cast<double>(cell.x), static_cast<double>(cell.y)}; }

// The plane of grey through the levels of a ring.
cv::Vec3d light_plane(const cv::Mat1f& levels, int from_edge) {
  cv::Matx33d normal = cv::Matx33d::zeros();
  cv::Vec3d right;
  visit_ring(levels, from_edge, [&](cv::Point cell) {
    const cv::Vec3d row = row_at(cell);
    normal += row * row.t();
    right += row * static_cast<double>(levels(cell));
  });
  return normal.solve(right, cv::DECOMP_CHOLESKY);
}

// One level of grey, half-way between the lightest of the border and the darkest of the ground around it.
cv::Vec3d level_between(const cv::Mat1f& levels) {
  float lightest = 0;
  float darkest = 255;
  visit_ring(levels, 1, [&](cv::Point cell) { lightest = std::max(lightest, levels(cell)); });
  visit_ring(levels, 0, [&](cv::Point cell) { darkest = std::min(darkest, levels(cell)); });
  return {(lightest + darkest) / 2, 0, 0};
}

bool is_light(const cv::Mat1f& levels, cv::Point cell, const cv::Vec3d& between) {
  return levels(cell) > between.dot(row_at(cell));
}

// How many cells of the border look light, and of the ground dark.
int wrong_around(const cv::Mat1f& levels, const cv::Vec3d& between) {
  int out = 0;
  visit_ring(levels, 1, [&](cv::Point cell) { out += is_light(levels, cell, between) ? 1 : 0; });
  visit_ring(levels, 0, [&](cv::Point cell) { out += is_light(levels, cell, between) ? 0 : 1; });
  return out;
}

// What splits light from dark: the plane half-way between both. Where the edge of a shadow makes either none, one
// level.
cv::Vec3d light_from_dark(const cv::Mat1f& levels) {
  const cv::Vec3d plane = (light_plane(levels, 0) + light_plane(levels, 1)) / 2;
  const cv::Vec3d level = level_between(levels);
  return wrong_around(levels, level) < wrong_around(levels, plane) ? level : plane;
}

struct Reading {
  int number = 0;
  TagCorners corners = {};
  double likeness = 0;
};

// Reads with these corners. Nothing if the border is not dark, or the cells spell no number.
std::optional<Reading> read_at(const cv::Mat1b& grey, TagCorners corners, cv::aruco::Dictionary& dictionary) {
  const int across = dictionary.markerSize;
  const cv::Mat1f levels = levels_of(grey, corners, across + 2);
  const cv::Vec3d between = light_from_dark(levels);
  int light = 0;
  visit_ring(levels, 1, [&](cv::Point cell) { light += is_light(levels, cell, between) ? 1 : 0; });
  if (light > most_light_share * 4 * (across + 1)) return std::nullopt;
  cv::Mat1b cells(across, across);
  for (int y = 0; y < across; ++y) {
    for (int x = 0; x < across; ++x) cells(y, x) = is_light(levels, {x + 2, y + 2}, between) ? 1 : 0;
  }
  Reading out;
  int quarter_turns = 0;
  if (!dictionary.identify(cells, out.number, quarter_turns, mended_share)) return std::nullopt;
  std::ranges::rotate(corners, corners.begin() + (4 - quarter_turns) % 4);
  out.corners = std::move(corners);
  return out;
}

bool is_within(const TagCorners& corners, const cv::Mat1b& grey) {
  const cv::Rect2f image(0, 0, static_cast<float>(grey.cols), static_cast<float>(grey.rows));
  return std::ranges::all_of(corners, [&](const cv::Point2f& p) { return image.contains(p); });
}

// Keeps in `best` the corners at which the image is most like the print: those read with, or fitted ones.
void fit(const cv::Mat1b& grey, const TagFamily& family, Reading read, std::optional<Reading>& best) {
  for (int fits = 0;; ++fits) {
    if (!is_within(read.corners, grey)) return;
    if (has_a_border(grey, read.corners, family)) {
      read.likeness = tag_likeness(grey, read.corners, family, read.number);
      if (read.likeness > (best ? best->likeness : least_tag_likeness(family))) best = read;
    }
    if (fits == most_fits) return;
    read.corners = fitted_corners(grey, read.corners, family, read.number);
  }
}

std::optional<Reading> best_reading(const cv::Mat1b& grey, const TagCorners& square, const TagFamily& family) {
  const cv::Ptr<cv::aruco::Dictionary> dictionary = dictionary_of(family);
  const int cells = dictionary->markerSize + 2;
  if (side_px(square) / cells < least_cell_px) return std::nullopt;
  std::optional<Reading> best;
  for (const TagCorners& corners : {square, refined(grey, square, cells)}) {
    std::optional<Reading> read = read_at(grey, corners, *dictionary);
    if (read) fit(grey, family, std::move(*read), best);
  }
  return best;
}

}  // namespace

void read_again(const cv::Mat1b& grey, const TagFamily& family, TagDetection& detection) {
  std::vector<Reading> readings;
  std::erase_if(detection.others, [&](const TagCorners& square) {
    std::optional<Reading> read = best_reading(grey, square, family);
    if (read) readings.push_back(std::move(*read));
    return read.has_value();
  });
  std::ranges::stable_sort(readings, std::greater<>(), &Reading::likeness);
  for (Reading& read : readings) {
    if (is_read(detection, read.corners)) continue;
    detection.found.push_back(std::move(read.corners));
    detection.numbers.push_back(read.number);
  }
}

void fit_again(const cv::Mat1b& grey, const TagFamily& family, TagDetection& detection) {
  for (std::size_t i = 0; i < detection.found.size(); ++i) {
    if (middle_off_px(grey, detection.found[i], family, detection.numbers[i]) < hardly_off_px) continue;
    std::optional<Reading> best;
    fit(grey, family, {detection.numbers[i], detection.found[i], 0}, best);
    if (best) detection.found[i] = std::move(best->corners);
  }
}

}  // namespace pizarra::vision
