#include "agents/vision/marks/mark_ground.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "agents/vision/image/levels.hpp"
#include "agents/vision/marks/ground_step.hpp"

namespace pizarra::vision {
namespace {

// Of the contour so many places tell enough.
constexpr std::size_t most_places = 96;
constexpr std::size_t least_places = 12;
// Where the contour turns by more than that it has a corner, beyond which blur leaves less of the mark.
const double cosine_of_corner = std::cos(40 * CV_PI / 180);
// How far outside its edge the ground is looked at. Nearer there is most of the mark's own blur, farther that of where
// a narrow margin ends; what hides a part is there at both.
constexpr std::array beyond_edge_px = {1.25, 2.0};
constexpr double well_outside_px = 2.5;

double level_at(const cv::Mat1b& grey, cv::Point2d place) {
  return level_between(grey,
                       {std::clamp(place.x, 0.0, grey.cols - 1.001), std::clamp(place.y, 0.0, grey.rows - 1.001)});
}

struct Place {
  cv::Point2d at;
  cv::Point2d outwards;  // 1 px
  std::size_t part;

  cv::Point2d beyond(double px) const { return at + px * outwards; }
};

// Along the contour, without its corners.
std::vector<Place> places_along(const MarkContour& contour) {
  const std::size_t size = contour.size();
  const std::size_t reach = std::max<std::size_t>(3, size / 32);
  const std::size_t count = std::min(size, most_places);
  const double side = signed_area(contour) > 0 ? 1 : -1;
  std::vector<Place> out;
  out.reserve(count);
  for (std::size_t i = 0; size >= least_places && i < count; ++i) {
    const std::size_t here = i * size / count;
    const cv::Point2d at = contour[here];
    const cv::Point2d before = at - cv::Point2d(contour[(here + size - reach) % size]);
    const cv::Point2d after = cv::Point2d(contour[(here + reach) % size]) - at;
    if (before.dot(after) < cosine_of_corner * std::sqrt(before.dot(before) * after.dot(after))) continue;
    const cv::Point2d along = before + after;
    const cv::Point2d outwards = side / std::sqrt(along.dot(along)) * cv::Point2d(along.y, -along.x);
    out.push_back({at, outwards, i * around_parts / count});
  }
  return out;
}

// How far outside the place its edge is, where the level passes the middle.
double edge_px(const cv::Mat1b& grey, const Place& place, double middle) {
  constexpr double between_pixels = 0.5;
  double before = level_at(grey, place.beyond(-1)) - middle;
  for (const int px : {0, 1, 2}) {
    const double now = level_at(grey, place.beyond(px)) - middle;
    if ((now > 0) != (before > 0)) return px - 1 + before / (before - now);
    before = now;
  }
  return between_pixels;
}

struct Ground {
  std::array<Around, beyond_edge_px.size()> beyond{};
  double contrast = 0;
};

Ground ground_of(const cv::Mat1b& grey, const std::vector<Place>& places, cv::Point2d centre) {
  Ground out;
  double inside = 0;
  double outside = 0;
  for (const Place& place : places) {
    inside += level_at(grey, place.beyond(-1));
    outside += level_at(grey, place.beyond(well_outside_px));
  }
  const auto count = static_cast<double>(places.size());
  out.contrast = std::abs(outside - inside) / count;
  for (const Place& place : places) {
    const double edge = edge_px(grey, place, (inside + outside) / 2 / count);
    for (std::size_t i = 0; i < beyond_edge_px.size(); ++i) {
      const cv::Point2d at = place.beyond(edge + beyond_edge_px[i]);
      out.beyond[i][place.part] += {1, at - centre, level_at(grey, at)};
    }
  }
  return out;
}

}  // namespace

double ground_doubt(const cv::Mat1b& grey, double noise, const SeenMark& mark) {
  const std::vector<Place> places = places_along(mark.contour);
  if (places.size() < least_places) return 0;
  const Ground ground = ground_of(grey, places, mark.centre);
  double least = step_doubt(ground.beyond.front(), ground.contrast, noise);
  for (std::size_t i = 1; i < beyond_edge_px.size() && least > 0; ++i) {
    least = std::min(least, step_doubt(ground.beyond[i], ground.contrast, noise));
  }
  return least;
}

}  // namespace pizarra::vision
