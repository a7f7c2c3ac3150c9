#include "agents/vision/marks/outline_ground.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "agents/vision/image/levels.hpp"
#include "agents/vision/marks/ground_step.hpp"

namespace pizarra::vision {
namespace {

// So far inside there is print that no blur mixes with the ground: in standard deviations of the mark, and px.
constexpr double deep = 0.35;
constexpr double deep_px = 3.5;
// No border may be nearer to it than this part of that.
constexpr double least_of_deep = 0.8;
constexpr double least_parts = 8;
constexpr double most_certain = 50;
// Before anything is seen of the print: what hides a part is to be excluded.
constexpr double covers_for_one_light = 9;

struct PrintAndGround {
  Around ground{};
  // Where the print is wide enough to be measured.
  Around print{};
  Around beside_print{};
};

// Inside the border at that point; nothing where the print is too narrow for that.
std::optional<cv::Vec2d> print_beside(const PlaneOutline& outline, const PlaneOutline::Point& point, double depth) {
  const cv::Vec2d place = point.at - depth * point.out;
  const auto is_near = [&](const PlaneOutline::Point& other) {
    return cv::norm(other.at - place) < least_of_deep * depth;
  };
  return std::ranges::any_of(outline.points, is_near) ? std::nullopt : std::optional(place);
}

PrintAndGround samples_of(const cv::Mat1b& pixels, const PlaneOutline& outline, const PlaneFit& fit) {
  PrintAndGround out;
  const cv::Point2d middle = fit.in_image(outline.middle);
  const double depth = std::max(deep, deep_px / std::sqrt(std::abs(cv::determinant(fit.slope()))));
  for (const PlaneEdge& edge : fit.edges) {
    if (!edge.is_border) continue;
    const std::size_t part = edge.point * around_parts / outline.points.size();
    out.ground[part] += {1, edge.at - middle, edge.outer};
    const std::optional<cv::Vec2d> place = print_beside(outline, outline.points[edge.point], depth);
    if (!place) continue;
    out.beside_print[part] += {1, edge.at - middle, edge.outer};
    out.print[part] += {1, edge.at - middle, nearest_level(pixels, fit.in_image(*place))};
  }
  return out;
}

double mean_level(const Around& around) {
  LevelSamples all;
  for (const LevelSamples& part : around) all += part;
  return all.level / std::max(1.0, all.count);
}

double parts_seen(const Around& around) {
  return static_cast<double>(std::ranges::count_if(around, [](const LevelSamples& part) { return part.count > 0; }));
}

// How much likelier it is that light changes, than that something covers a side, 0 to 1. The light's slope is taken
// from print and ground, and by least squares it is found how much the print changes with the ground. It does not where
// something covers a side. In a shadow it changes in proportion to its level, and by as much as the ground where light
// is added to both.
double light_rather_than_cover(Around print, Around ground, double noise) {
  const double least_of_light = std::min(1.0, mean_level(print) / std::max(1.0, mean_level(ground)));
  flatten(print);
  flatten(ground);
  double ground2 = 0;
  double both = 0;
  double print2 = 0;
  for (std::size_t i = 0; i < around_parts; ++i) {
    const double count = std::max(1.0, ground[i].count);
    ground2 += ground[i].level * ground[i].level / count;
    both += ground[i].level * print[i].level / count;
    print2 += print[i].level * print[i].level / count;
  }
  const double slope = both / std::max(1.0, ground2);
  constexpr double unknowns = 4;
  const double scatter = (print2 - slope * both) / (parts_seen(ground) - unknowns);
  const double variance = std::max(scatter, variance_between_pixels(noise)) / std::max(1.0, ground2);
  const double off = std::max(0.0, least_of_light - slope);
  const double for_light = (slope * slope - off * off) / (2 * variance);
  return 1 / (1 + covers_for_one_light * std::exp(-std::clamp(for_light, -most_certain, most_certain)));
}

}  // namespace

OutlineGround look_at_ground(const ImageCut& cut, const PlaneOutline& outline, const PlaneFit& fit) {
  const PrintAndGround seen = samples_of(cut.pixels, outline, fit);
  OutlineGround out;
  if (parts_seen(seen.ground) < least_parts) return out;
  out.doubt = step_doubt(seen.ground, std::abs(mean_level(seen.ground) - mean_level(seen.print)), cut.noise);
  if (parts_seen(seen.print) < least_parts) return out;
  out.light = light_rather_than_cover(seen.print, seen.beside_print, cut.noise);
  return out;
}

}  // namespace pizarra::vision
