#include "agents/vision/marks/cut_outline.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pizarra::vision {
namespace {

using Border = std::vector<cv::Point2d>;

// An edge hides this share of the area. The rest must differ from each affine view of the whole by this much at least,
// a root mean square in standard deviations of the mark. A circle's rest differs by 0.11, a cross' by 0.16. The rest of
// a square or a triangle differs by 0.03 to 0.04, because the template rounds corners. The bound lies between.
constexpr double share_cut_off = 0.1;
constexpr double least_of_cut = 0.07;
constexpr std::size_t every = 3;  // of the outline's places
constexpr int directions = 24;
constexpr int halvings = 12;
constexpr double longest_step = 0.1;  // standard deviations of the mark

double area_of(const Border& closed) {
  double out = 0;
  for (std::size_t i = 0; i < closed.size(); ++i) out += closed[i].cross(closed[(i + 1) % closed.size()]) / 2;
  return std::abs(out);
}

// With places along the cut as well.
Border finely(const Border& closed) {
  Border out;
  for (std::size_t i = 0; i < closed.size(); ++i) {
    const cv::Point2d way = closed[(i + 1) % closed.size()] - closed[i];
    const int steps = std::max(1, cvCeil(cv::norm(way) / longest_step));
    for (int k = 0; k < steps; ++k) out.push_back(closed[i] + static_cast<double>(k) / steps * way);
  }
  return out;
}

// What is no farther than `most` along `way` (I. E. Sutherland, G. W. Hodgman, Reentrant polygon clipping, 1974).
Border up_to(const Border& closed, const cv::Point2d& way, double most) {
  Border out;
  for (std::size_t i = 0; i < closed.size(); ++i) {
    const cv::Point2d& p = closed[i];
    const cv::Point2d& q = closed[(i + 1) % closed.size()];
    const double here = p.dot(way) - most;
    const double next = q.dot(way) - most;
    if (here <= 0) out.push_back(p);
    if ((here < 0 && next > 0) || (here > 0 && next < 0)) out.push_back(p + here / (here - next) * (q - p));
  }
  return out;
}

Border without(const Border& whole, const cv::Vec2d& towards, double share) {
  const cv::Point2d way(towards[0], towards[1]);
  const auto along = [&](const cv::Point2d& p) { return p.dot(way); };
  auto [low, high] = std::ranges::minmax(whole, {}, along);
  double least = low.dot(way);
  double most = high.dot(way);
  const double rest = (1 - share) * area_of(whole);
  for (int i = 0; i < halvings; ++i) {
    const double middle = (least + most) / 2;
    (area_of(up_to(whole, way, middle)) < rest ? least : most) = middle;
  }
  return finely(up_to(whole, way, most));
}

}  // namespace

bool form_shows_cuts(const PlaneOutline& outline) {
  Border whole;
  for (std::size_t i = 0; i < outline.outermost; ++i) {
    whole.emplace_back(outline.points[i].at[0], outline.points[i].at[1]);
  }
  if (whole.empty()) return false;
  const auto is_shown_from = [&](const cv::Vec2d& towards) {
    const std::optional<Reach> rest = reach_of(without(whole, towards, share_cut_off));
    return rest && fit_reach(*rest, outline.reach).error >= least_of_cut;
  };
  // From everywhere, and along its own edges: of a convex form these show least.
  for (int i = 0; i < directions; ++i) {
    const double turn = 2 * std::numbers::pi * i / directions;
    if (!is_shown_from({std::cos(turn), std::sin(turn)})) return false;
  }
  for (std::size_t i = 0; i < outline.outermost; i += every) {
    if (!is_shown_from(outline.points[i].out)) return false;
  }
  return true;
}

}  // namespace pizarra::vision
