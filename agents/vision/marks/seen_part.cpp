#include "agents/vision/marks/seen_part.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "agents/vision/image/levels.hpp"
#include "agents/vision/marks/robust.hpp"

namespace pizarra::vision {
namespace {

// So far inside there is ink, in standard deviations of the mark; and so far on either side there is no blur, px.
constexpr double deep_inside = 0.35;
constexpr double beside_px = 3;
// The same, of how far the ink reaches inwards. What hides a part may lie deeper.
constexpr double deeper_inside = 0.3;
// By how much the levels of one print differ, as a part of its contrast, and by the noise.
constexpr double same_level = 0.13;
constexpr double same_in_noise = 3;
// By how much the ground of one paper differs from one place of the border to another, as a part of the contrast: at
// least, and in what most places scatter by. A cover is seldom as even as that, and as light.
constexpr double same_ground = 0.03;
constexpr double same_in_scatter = 3;
// Paper is so many times as light as ink, in a shadow too.
constexpr double least_ratio = 2;

// The ink and the ground, as most of the border shows them.
struct Print {
  double ink = 0;
  double ground = 0;

  Print(const PlaneFit& fit, double noise) {
    std::vector<double> inner;
    std::vector<double> outer;
    for (const PlaneEdge& edge : fit.edges) {
      if (!edge.is_border) continue;
      inner.push_back(edge.inner);
      outer.push_back(edge.outer);
    }
    ink = median(inner);
    ground = median(outer);
    const double contrast = std::abs(ground - ink);
    slack_ = std::hypot(same_level * contrast, same_in_noise * noise);
    for (double& level : outer) level = std::abs(level - ground);
    const double scatter = std::max(same_ground * contrast, same_in_scatter * median(std::move(outer)));
    ground_slack_ = std::min(slack_, std::hypot(scatter, same_in_noise * noise));
  }
  double ratio(MarkTone tone) const {
    constexpr double darkest = 1;
    const auto [dark, light] = tone == MarkTone::dark ? std::pair(ink, ground) : std::pair(ground, ink);
    return light / std::max(dark, darkest);
  }
  bool is_print(MarkTone tone) const { return ratio(tone) > least_ratio; }
  bool is_ink(double level) const { return std::abs(level - ink) < slack_; }
  bool is_ground(double level) const { return std::abs(level - ground) < slack_; }
  bool is_this_ground(double level) const { return std::abs(level - ground) < ground_slack_; }

 private:
  double slack_ = 0;
  double ground_slack_ = 0;
};

// How much the levels of the supporting places scatter on the side where they do so more, as a part of the contrast.
double unevenness(const PlaneFit& fit, const Print& print) {
  double inner = 0;
  double outer = 0;
  int count = 0;
  for (const PlaneEdge& edge : fit.edges) {
    if (!edge.is_border) continue;
    inner += (edge.inner - print.ink) * (edge.inner - print.ink);
    outer += (edge.outer - print.ground) * (edge.outer - print.ground);
    ++count;
  }
  return count == 0 ? 0 : std::sqrt(std::max(inner, outer) / count) / std::max(1.0, std::abs(print.ground - print.ink));
}

}  // namespace

SeenPart judge_part(const ImageCut& cut, const PlaneOutline& outline, PlaneFit& fit, MarkTone tone) {
  const cv::Mat1b& pixels = cut.pixels;
  const Print print(fit, cut.noise);
  const bool is_there = print.is_print(tone);
  int counted = 0;
  int supported = 0;
  int contradicted = 0;
  int going_on = 0;
  int filled = 0;
  double squares = 0;
  for (PlaneEdge& edge : fit.edges) {
    if (!edge.counts) continue;
    const PlaneOutline::Point& point = outline.points[edge.point];
    const cv::Point2d inward = -cv::Point2d(edge.normal[0], edge.normal[1]);
    const bool is_print = edge.found && is_there && print.is_ink(edge.inner) && print.is_ground(edge.outer) &&
                          print.is_ink(nearest_level(pixels, fit.in_image(point.at - deep_inside * point.out)));
    edge.is_border = edge.is_border && is_print;
    // The template rounds what is sharp.
    if (is_print && !edge.is_border && point.is_rounded()) continue;
    ++counted;
    if (edge.is_border) {
      ++supported;
      const cv::Point2d deeper = fit.in_image(point.at - deeper_inside * point.depth * point.out);
      filled += print.is_ink(nearest_level(pixels, deeper)) ? 1 : 0;
      squares += edge.off_px * edge.off_px;
      continue;
    }
    const cv::Point2d at = fit.in_image(point.at);
    const double inside = nearest_level(pixels, at + beside_px * inward);
    const double outside = nearest_level(pixels, at - beside_px * inward);
    const bool none_there = print.is_this_ground(inside) && print.is_this_ground(outside);
    going_on += print.is_ink(inside) && print.is_ink(outside) ? 1 : 0;
    contradicted += none_there || (is_print && print.is_this_ground(edge.outer)) ? 1 : 0;
  }
  SeenPart out;
  if (counted == 0 || supported == 0) return out;
  out.supported = static_cast<double>(supported) / counted;
  out.contradicted = static_cast<double>(contradicted) / counted;
  out.goes_on = static_cast<double>(going_on) / counted;
  out.hidden = 1 - out.supported - out.contradicted;
  out.filled = static_cast<double>(filled) / supported;
  out.rms_px = std::sqrt(squares / supported);
  out.ink = print.ink;
  out.ground = print.ground;
  out.ratio = print.ratio(tone);
  out.uneven = unevenness(fit, print);
  double length = 0;
  for (std::size_t i = 1; i < outline.points.size(); ++i) {
    if (fit.edges[i].is_border) {
      length += cv::norm(fit.in_image(outline.points[i].at) - fit.in_image(outline.points[i - 1].at));
    }
  }
  out.supported_px = length;
  return out;
}

}  // namespace pizarra::vision
