#include "agents/vision/mark_measure.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace pizarra {
namespace {

constexpr int margin_px = 4;
constexpr double least_contrast = 30;

struct Region {
  cv::Rect box;
  cv::Mat1b inside;  // 255 where the contour encloses
  cv::Mat1b around;  // grown by two pixels, within which blur spreads the mark
  cv::Mat1b border;  // the outermost pixel of `around`: even ground on a clean mark
  cv::Mat1b core;    // shrunk by one pixel
};

std::optional<Region> region_of(const cv::Mat& grey, const MarkContour& contour) {
  Region out;
  const cv::Rect tight = cv::boundingRect(contour);
  out.box = {tight.x - margin_px, tight.y - margin_px, tight.width + 2 * margin_px, tight.height + 2 * margin_px};
  if ((out.box & cv::Rect(0, 0, grey.cols, grey.rows)) != out.box) return std::nullopt;
  out.inside = cv::Mat1b::zeros(out.box.size());
  MarkContour shifted(contour);
  for (cv::Point& p : shifted) p -= out.box.tl();
  cv::fillPoly(out.inside, std::vector<MarkContour>{shifted}, 255);
  static const cv::Mat square = cv::getStructuringElement(cv::MORPH_RECT, {3, 3});
  cv::Mat1b grown;
  cv::dilate(out.inside, grown, square);
  cv::dilate(grown, out.around, square);
  out.border = out.around - grown;
  cv::erode(out.inside, out.core, square);
  return out;
}

// The median of the pixels under a mask, and which share of them lies within `tolerance` of it.
struct Level {
  int median = 0;
  int count = 0;
  std::array<int, 256> histogram{};

  double share_within(int tolerance) const {
    int near = 0;
    for (int i = std::max(0, median - tolerance); i <= std::min(255, median + tolerance); ++i) {
      near += histogram[static_cast<std::size_t>(i)];
    }
    return count == 0 ? 0 : static_cast<double>(near) / count;
  }
};

Level level_under(const cv::Mat& grey, const cv::Mat1b& mask) {
  Level out;
  for (int y = 0; y < mask.rows; ++y) {
    const auto* pixels = grey.ptr<std::uint8_t>(y);
    const auto* under = mask.ptr<std::uint8_t>(y);
    for (int x = 0; x < mask.cols; ++x) {
      if (under[x] == 0) continue;
      ++out.histogram[pixels[x]];
      ++out.count;
    }
  }
  int seen = 0;
  while (out.median < 255 && (seen += out.histogram[static_cast<std::size_t>(out.median)]) * 2 < out.count) {
    ++out.median;
  }
  return out;
}

// 1 where the mark is, 0 where the ground is, in between where an edge crosses a pixel. Not clamped: noise must not add
// weight. What lies two pixels outside and is yet unlike the ground belongs to something else. A light gradient moves
// the centre a little, by the same in both images (0.06 px at 30 % over the image's width); fitting the light per mark
// would cost more in depth than it gains.
cv::Mat1f weights_of(const cv::Mat& grey, const Region& region, double mark_level, double ground_level) {
  cv::Mat1f out = cv::Mat1f::zeros(region.box.size());
  const double scale = 1 / (mark_level - ground_level);
  for (int y = 0; y < out.rows; ++y) {
    const auto* pixels = grey.ptr<std::uint8_t>(y);
    const auto* around = region.around.ptr<std::uint8_t>(y);
    const auto* border = region.border.ptr<std::uint8_t>(y);
    auto* weights = out.ptr<float>(y);
    for (int x = 0; x < out.cols; ++x) {
      if (around[x] == 0) continue;
      const double weight = (pixels[x] - ground_level) * scale;
      if (border[x] != 0 && std::abs(weight) > 0.3) continue;
      weights[x] = static_cast<float>(weight);
    }
  }
  return out;
}

struct Moments {
  double m00, x, y, mu20, mu11, mu02, mu30, mu21, mu12, mu03;
};

std::optional<Moments> moments_of(const cv::Mat1f& weights) {
  Moments m{};
  double m10 = 0;
  double m01 = 0;
  for (int y = 0; y < weights.rows; ++y) {
    const float* row = weights.ptr<float>(y);
    for (int x = 0; x < weights.cols; ++x) {
      const double w = row[x];
      m.m00 += w;
      m10 += w * x;
      m01 += w * y;
    }
  }
  if (m.m00 < 1) return std::nullopt;
  m.x = m10 / m.m00;
  m.y = m01 / m.m00;
  for (int y = 0; y < weights.rows; ++y) {
    const float* row = weights.ptr<float>(y);
    const double v = y - m.y;
    for (int x = 0; x < weights.cols; ++x) {
      const double w = row[x];
      if (w == 0) continue;
      const double u = x - m.x;
      m.mu20 += w * u * u;
      m.mu11 += w * u * v;
      m.mu02 += w * v * v;
      m.mu30 += w * u * u * u;
      m.mu21 += w * u * u * v;
      m.mu12 += w * u * v * v;
      m.mu03 += w * v * v * v;
    }
  }
  if (m.mu20 <= 0 || m.mu02 <= 0 || m.mu20 * m.mu02 <= m.mu11 * m.mu11) return std::nullopt;
  return m;
}

// M. K. Hu, Visual Pattern Recognition by Moment Invariants, 1962.
std::array<double, 3> hu_moments(const Moments& m) {
  const double second = m.m00 * m.m00;
  const double third = second * std::sqrt(m.m00);
  const double n20 = m.mu20 / second;
  const double n02 = m.mu02 / second;
  const double n11 = m.mu11 / second;
  const double h1 = n20 + n02;
  const double h2 = (n20 - n02) * (n20 - n02) + 4 * n11 * n11;
  const double a = (m.mu30 - 3 * m.mu12) / third;
  const double b = (3 * m.mu21 - m.mu03) / third;
  return {2 * CV_PI * h1, 1e6 * h2, 1e9 * (a * a + b * b)};
}

// The symmetric square root of a 2x2 covariance: (S + sqrt(det S) I) / sqrt(trace S + 2 sqrt(det S)).
cv::Matx22d spread_of(const Moments& m) {
  const double a = m.mu20 / m.m00;
  const double b = m.mu11 / m.m00;
  const double d = m.mu02 / m.m00;
  const double root = std::sqrt(a * d - b * b);
  const double scale = 1 / std::sqrt(a + d + 2 * root);
  return {(a + root) * scale, b * scale, b * scale, (d + root) * scale};
}

double slimness_of(const Moments& m) {
  const double mean = (m.mu20 + m.mu02) / 2;
  const double half = std::hypot((m.mu20 - m.mu02) / 2, m.mu11);
  return std::sqrt(std::max(0.0, mean - half) / (mean + half));
}

}  // namespace

std::optional<SeenMark> measure_mark(const cv::Mat& grey, const MarkContour& contour, MarkTone tone) {
  const std::optional<Region> region = region_of(grey, contour);
  if (!region) return std::nullopt;
  const cv::Mat patch = grey(region->box);
  const Level mark = level_under(patch, region->core);
  const Level ground = level_under(patch, region->border);
  const int contrast = tone == MarkTone::dark ? ground.median - mark.median : mark.median - ground.median;
  if (mark.count == 0 || contrast < least_contrast) return std::nullopt;
  if (mark.share_within(contrast / 3) < 0.85 || ground.share_within(contrast / 5) < 0.75) return std::nullopt;

  SeenMark out;
  out.tone = tone;
  out.contour = contour;
  out.mark_level = mark.median;
  out.ground_level = ground.median;
  out.shape.weights = weights_of(patch, *region, mark.median, ground.median);
  const std::optional<Moments> moments = moments_of(out.shape.weights);
  if (!moments) return std::nullopt;
  out.shape.centre = {moments->x, moments->y};
  out.shape.spread = spread_of(*moments);
  out.centre = cv::Point2d(region->box.tl()) + out.shape.centre;
  out.area_px = cv::countNonZero(region->inside);
  out.perimeter_px = static_cast<int>(contour.size());
  out.corners = count_corners(contour);
  out.moments = hu_moments(*moments);
  out.width_px = std::sqrt(moments->mu20 / moments->m00);
  out.height_px = std::sqrt(moments->mu02 / moments->m00);
  out.slimness = slimness_of(*moments);
  out.roundness = 4 * CV_PI * std::sqrt(moments->mu20 * moments->mu02 - moments->mu11 * moments->mu11) /
                  (moments->m00 * moments->m00);
  out.signature = signature_of(out.shape);
  return out;
}

int count_corners(const MarkContour& contour) {
  const int size = static_cast<int>(contour.size());
  const int reach = std::clamp(size / 16, 2, 6);
  if (size < 4 * reach) return 0;
  const auto at = [&](int i) { return contour[static_cast<std::size_t>((i + size) % size)]; };
  std::vector<double> turn(contour.size());
  for (int i = 0; i < size; ++i) {
    const cv::Point before = at(i) - at(i - reach);
    const cv::Point after = at(i + reach) - at(i);
    turn[static_cast<std::size_t>(i)] = std::abs(std::atan2(before.cross(after), before.dot(after)));
  }
  int corners = 0;
  for (int i = 0; i < size; ++i) {
    const double here = turn[static_cast<std::size_t>(i)];
    bool peak = here > 50 * CV_PI / 180;
    for (int step = 1; step <= reach && peak; ++step) {
      peak = here > turn[static_cast<std::size_t>((i - step + size) % size)] &&
             here >= turn[static_cast<std::size_t>((i + step) % size)];
    }
    corners += peak ? 1 : 0;
  }
  return corners;
}

}  // namespace pizarra
