#include "agents/vision/marks/outline_ground.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "agents/vision/image/levels.hpp"
#include "agents/vision/marks/ground_step.hpp"
#include "agents/vision/marks/light_or_cover.hpp"

namespace pizarra::vision {
namespace {

// So far inside there is print that no blur mixes with the ground: in standard deviations of the mark, and px.
constexpr double deep = 0.35;
constexpr double deep_px = 3.5;
// No border may be nearer to it than this part of that.
constexpr double least_of_deep = 0.8;
constexpr std::ptrdiff_t least_parts = 8;
// With less doubt it does not matter what makes it.
constexpr double hardly_uneven = 0.25;

struct Sides {
  Around ground{};
  double contrast = 0;
  std::vector<PrintBeside> places = {};  // where the print is wide enough to be measured
};

// Inside the border at that point; nothing where the print is too narrow for that.
std::optional<cv::Vec2d> print_beside(const PlaneOutline& outline, const PlaneOutline::Point& point, double depth) {
  const cv::Vec2d place = point.at - depth * point.out;
  const auto is_near = [&](const PlaneOutline::Point& other) {
    return cv::norm(other.at - place) < least_of_deep * depth;
  };
  return std::ranges::any_of(outline.points, is_near) ? std::nullopt : std::optional(place);
}

Sides sides_of(const cv::Mat1b& pixels, const PlaneOutline& outline, const PlaneFit& fit) {
  Sides out;
  const cv::Point2d middle = fit.in_image(outline.middle);
  const double depth = std::max(deep, deep_px / fit.size_px());
  double ground = 0;
  double print = 0;
  int borders = 0;
  for (const PlaneEdge& edge : fit.edges) {
    if (!edge.is_border) continue;
    const std::size_t part = edge.point * around_parts / outline.points.size();
    out.ground[part] += {1, edge.at - middle, edge.outer};
    ground += edge.outer;
    ++borders;
    const std::optional<cv::Vec2d> place = print_beside(outline, outline.points[edge.point], depth);
    if (!place) continue;
    out.places.push_back({part, edge.at - middle, edge.outer, nearest_level(pixels, fit.in_image(*place))});
    print += out.places.back().print;
  }
  out.contrast =
      std::abs(ground / std::max(1, borders) - print / std::max(1.0, static_cast<double>(out.places.size())));
  return out;
}

}  // namespace

OutlineGround look_at_ground(const ImageCut& cut, const PlaneOutline& outline, const PlaneFit& fit) {
  const Sides sides = sides_of(cut.pixels, outline, fit);
  OutlineGround out;
  const auto is_seen = [](const LevelSamples& part) { return part.count > 0; };
  if (std::ranges::count_if(sides.ground, is_seen) < least_parts) return out;
  out.doubt = step_doubt(sides.ground, sides.contrast, cut.noise);
  if (out.doubt < hardly_uneven) return out;
  out.light = light_rather_than_cover(sides.places, cut.noise);
  return out;
}

}  // namespace pizarra::vision
