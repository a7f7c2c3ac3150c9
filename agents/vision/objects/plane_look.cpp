#include "agents/vision/objects/plane_look.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "agents/vision/marks/covariance.hpp"
#include "agents/vision/marks/robust.hpp"

namespace pizarra::vision {
namespace {

// An outline that is farther off than this, in standard deviations, is another; perspective, and how few pixels say
// where a deep one turns in, make some of it.
constexpr double most_reach_error = 0.15;
constexpr double most_error_of_deep = 0.5;  // of how much the outline itself varies
constexpr double least_supported = 0.85;
// Of several turns that are worse than the best one by no more, one is as likely as another.
constexpr double same_reach_error = 0.02;
// An edge is off by no more of the mark's standard deviation, and of a pixel.
constexpr double most_rms_share = 0.035;
constexpr double most_rms_px = 0.35;

constexpr int full = 240;
// Around the mark, turn by turn, how light it and its ground are.
constexpr int turns = 32;
constexpr double most_stray = 0.3;

class LocalLight {
 public:
  LocalLight(const PlaneFit& fit, const PlaneOutline& outline) {
    std::vector<double> all_inner;
    std::vector<double> all_outer;
    std::array<int, turns> counts{};
    for (const PlaneEdge& edge : fit.edges) {
      if (!edge.is_border) continue;
      const std::size_t turn = turn_of(outline.points[edge.point].at);
      inner_[turn] += edge.inner;
      outer_[turn] += edge.outer;
      ++counts[turn];
      all_inner.push_back(edge.inner);
      all_outer.push_back(edge.outer);
    }
    inner = median(all_inner);
    outer = median(all_outer);
    for (std::size_t i = 0; i < turns; ++i) {
      inner_[i] = counts[i] > 0 ? inner_[i] / counts[i] : inner;
      outer_[i] = counts[i] > 0 ? outer_[i] / counts[i] : outer;
    }
  }
  // 1 where it is as the mark, 0 as the ground beside it there.
  double share(const cv::Vec2d& place, double level) const {
    const std::size_t turn = turn_of(place);
    const double contrast = outer_[turn] - inner_[turn];
    return std::abs(contrast) < 1 ? 0 : std::clamp((outer_[turn] - level) / contrast, -1.0, 2.0);
  }
  double inner = 0;
  double outer = 0;

 private:
  static std::size_t turn_of(const cv::Vec2d& place) {
    const double turn = std::atan2(place[1], place[0]) * turns / (2 * std::numbers::pi);
    return static_cast<std::size_t>((cvRound(turn) + 2 * turns) % turns);
  }
  std::array<double, turns> inner_{};
  std::array<double, turns> outer_{};
};

using Weights = std::array<std::int16_t, template_size * template_size>;

// The mean of what a template's pixel shows of the image; nothing beyond that.
double mean_level(const cv::Mat1b& pixels, const PlaneFit& fit, const cv::Vec2d& place, int samples) {
  double sum = 0;
  int count = 0;
  for (int i = 0; i < samples * samples; ++i) {
    const auto part = [&](int k) { return ((k + 0.5) / samples - 0.5) / template_scale; };
    const cv::Point2d at = fit.in_image({place[0] + part(i % samples), place[1] + part(i / samples)});
    if (at.x < 0 || at.y < 0 || at.x >= pixels.cols - 1 || at.y >= pixels.rows - 1) continue;
    const int x = static_cast<int>(at.x);
    const int y = static_cast<int>(at.y);
    const double a = at.x - x;
    const double b = at.y - y;
    sum += (1 - b) * ((1 - a) * pixels(y, x) + a * pixels(y, x + 1)) +
           b * ((1 - a) * pixels(y + 1, x) + a * pixels(y + 1, x + 1));
    ++count;
  }
  return count == 0 ? -1 : sum / count;
}

Weights flattened(const cv::Mat1b& pixels, const PlaneFit& fit, const PlaneOutline& outline,
                  const MarkTemplate& picture, const LocalLight& light) {
  Weights out{};
  const double px = fit.size_px();
  const int samples = std::clamp(cvCeil(px / template_scale), 1, 4);
  for (int y = 1; y < template_size - 1; ++y) {
    for (int x = 1; x < template_size - 1; ++x) {
      const auto i = static_cast<std::size_t>(y) * template_size + static_cast<std::size_t>(x);
      if (!outline.near[i]) continue;
      const cv::Vec2d place((x - template_size / 2.0) / template_scale, (y - template_size / 2.0) / template_scale);
      const double level = mean_level(pixels, fit, place, samples);
      const double share = level < 0 ? 0 : light.share(place, level);
      // Something else near the mark.
      if (picture[i] == 0 && std::abs(share) > most_stray) continue;
      out[i] = static_cast<std::int16_t>(std::lround(full * share));
    }
  }
  return out;
}

struct Moments {
  double sum = 0;
  cv::Vec2d middle;
  double xx = 0, xy = 0, yy = 0;
};

std::optional<Moments> moments_of(const Weights& weights) {
  Moments out;
  double x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  std::size_t i = 0;
  for (int row = 0; row < template_size; ++row) {
    for (int column = 0; column < template_size; ++column) {
      const double w = weights[i++];
      out.sum += w;
      x += w * column;
      y += w * row;
      xx += w * column * column;
      xy += w * column * row;
      yy += w * row * row;
    }
  }
  if (out.sum < full) return std::nullopt;
  out.middle = {x / out.sum, y / out.sum};
  out.xx = xx / out.sum - out.middle[0] * out.middle[0];
  out.xy = xy / out.sum - out.middle[0] * out.middle[1];
  out.yy = yy / out.sum - out.middle[1] * out.middle[1];
  if (out.xx <= 0 || out.yy <= 0 || out.xx * out.yy <= out.xy * out.xy) return std::nullopt;
  return out;
}

MarkSignature signature_in_plane(const Weights& weights, const Moments& moments) {
  return signature_of({.weights = weights.data(),
                       .stride = template_size,
                       .size = {template_size, template_size},
                       .centre = {moments.middle[0], moments.middle[1]},
                       .spread = root_of({moments.xx, moments.xy, moments.xy, moments.yy}),
                       .full = full});
}

// How much slimmer than from the front the mark is where it is turned so, as a logarithm.
double squeeze(const LearnedSample& sample, const cv::Matx33d& to_image) {
  const cv::Matx22d slope = to_image.get_minor<2, 2>(0, 0) * sample.stretch().inv();
  const cv::Matx22d spread = slope * slope.t();
  const double mean = cv::trace(spread) / 2;
  return std::acosh(std::max(1.0, mean / std::abs(cv::determinant(slope))));
}

// The template of a slim rectangle is a square, whose four turns are alike. A mark is seldom so aslant that the longer
// one of its sides is the shorter one.
cv::Matx33d start_of(const LearnedSample& sample, const Reach& region, const ReachFit& best) {
  const Reach& learned = sample.plane.reach;
  const cv::Matx33d by_reach = affine_start(region, learned, best.turn);
  if (sample.axis_deg <= 0) return by_reach;
  const std::array<double, Reach::turns> errors = reach_errors(region, learned);
  cv::Matx33d out = by_reach;
  for (int turn = 0; turn < Reach::turns; ++turn) {
    if (errors[static_cast<std::size_t>(turn)] > best.error + same_reach_error) continue;
    const cv::Matx33d other = affine_start(region, learned, turn);
    if (squeeze(sample, other) < squeeze(sample, out)) out = other;
  }
  return out;
}

std::optional<SeenMark> mark_of(const ImageCut& cut, const LearnedSample& sample, const LevelRegion& region,
                                const PlaneFit& fit) {
  const PlaneOutline& outline = sample.plane;
  const LocalLight light(fit, outline);
  const Weights weights = flattened(cut.pixels, fit, outline, sample.picture, light);
  const std::optional<Moments> moments = moments_of(weights);
  if (!moments) return std::nullopt;
  SeenMark out;
  out.tone = sample.tone;
  out.flattened = true;
  out.box = region.box;
  set_place(out, fit, outline.middle);
  const double size2 = std::abs(cv::determinant(fit.slope()));
  const double area = moments->sum / full;  // the template's pixels
  out.area_px = area * size2 / (template_scale * template_scale);
  out.perimeter_px = static_cast<int>(region.contour.size());
  out.roundness = 4 * std::numbers::pi * std::sqrt(moments->xx * moments->yy - moments->xy * moments->xy) / area;
  out.mark_level = light.inner;
  out.ground_level = light.outer;
  out.noise = cut.noise;
  out.signature = signature_in_plane(weights, *moments);
  out.contour = region.contour;
  return out;
}

}  // namespace

void set_place(SeenMark& mark, const PlaneFit& fit, const cv::Vec2d& middle) {
  mark.centre = fit.in_image(middle);
  // Of a standard deviation of one in the plane, as the image shows it.
  const cv::Matx22d slope = fit.slope();
  const cv::Matx22d spread = slope * slope.t();
  mark.width_px = std::sqrt(spread(0, 0));
  mark.height_px = std::sqrt(spread(1, 1));
  mark.slant_px2 = spread(0, 1);
  const double size2 = std::abs(cv::determinant(slope));
  const double mean = (spread(0, 0) + spread(1, 1)) / 2;
  const double half = std::sqrt(std::max(0.0, mean * mean - size2 * size2));
  mark.slimness = std::sqrt(std::max(0.0, mean - half) / (mean + half));
}

void set_outline(SeenMark& mark, const PlaneFit& fit, const LearnedSample& sample) {
  const PlaneOutline& outline = sample.plane;
  set_place(mark, fit, outline.middle);
  const double size = fit.size_px() / sample.height_px;
  mark.area_px = sample.area_px * size * size;
  mark.contour.clear();
  for (std::size_t i = 0; i < outline.outermost; ++i) {
    const cv::Point from = fit.in_image(outline.points[i].at);
    const cv::Point to = fit.in_image(outline.points[(i + 1) % outline.outermost].at);
    cv::LineIterator pixel(from, to);
    // The last one is the first of the next line.
    for (int k = 0; k + 1 < pixel.count; ++k, ++pixel) mark.contour.push_back(pixel.pos());
  }
  mark.box = cv::boundingRect(mark.contour);
  mark.perimeter_px = static_cast<int>(mark.contour.size());
}

std::optional<PlaneFit> fit_region(const ImageCut& cut, const LearnedSample& sample, const Reach& region) {
  if (sample.tag || sample.plane.points.empty()) return std::nullopt;
  const ReachFit turned = fit_reach(region, sample.plane.reach);
  if (turned.error > most_reach_error + most_error_of_deep * sample.plane.reach.variation()) return std::nullopt;
  return fit_plane(cut.pixels, sample.plane, start_of(sample, region, turned), sample.tone);
}

bool is_outline_of(const PlaneFit& fit) {
  const double size_px = fit.size_px();
  return fit.supported >= least_supported && fit.rms_px <= std::hypot(most_rms_px, most_rms_share * size_px);
}

std::optional<PlaneLook> seen_in_plane(const ImageCut& cut, const LearnedSample& sample, const LevelRegion& region) {
  std::optional<PlaneFit> fit = fit_region(cut, sample, region.reach);
  if (!fit || !is_outline_of(*fit)) return std::nullopt;
  std::optional<SeenMark> mark = mark_of(cut, sample, region, *fit);
  if (!mark) return std::nullopt;
  return PlaneLook{std::move(*mark), std::move(*fit)};
}

}  // namespace pizarra::vision
