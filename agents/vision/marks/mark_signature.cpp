#include "agents/vision/marks/mark_signature.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <opencv2/core/hal/intrin.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace pizarra {
namespace {

// In standard deviations; a circle ends at 2, a square between 1.7 and 2.4, a triangle's corners at 2.8.
constexpr std::array<double, MarkSignature::rings> ring_radii = {1.0, 1.4, 1.7, 2.05, 2.4, 2.7};
// How much of a radius each ring stands for, from 0.5 on.
constexpr std::array<double, MarkSignature::rings> ring_shares = {0.7, 0.35, 0.325, 0.35, 0.325, 0.15};
constexpr double quantum = 64;

// The samples' unit: the outer rings have more to tell.
double weight_of(std::size_t ring) { return quantum * std::sqrt(ring_radii[ring]); }

// Bilinear, in the units of the weights.
float sample(const WeightedShape& shape, float x, float y) {
  // Beyond the picture it is as on its border: 0.
  const float inside_x = std::clamp(x, 0.F, static_cast<float>(shape.size.width) - 1.001F);
  const float inside_y = std::clamp(y, 0.F, static_cast<float>(shape.size.height) - 1.001F);
  const int left = static_cast<int>(inside_x);
  const int top = static_cast<int>(inside_y);
  const std::int16_t* upper = shape.weights + top * shape.stride + left;
  const std::int16_t* lower = upper + shape.stride;
  const float fx = inside_x - static_cast<float>(left);
  const float fy = inside_y - static_cast<float>(top);
  const float above = static_cast<float>(upper[0]) + fx * static_cast<float>(upper[1] - upper[0]);
  const float below = static_cast<float>(lower[0]) + fx * static_cast<float>(lower[1] - lower[0]);
  return above + fy * (below - above);
}

// sample() of four places at once, given in px.
cv::v_float32x4 sample(const WeightedShape& shape, cv::v_float32x4 x, cv::v_float32x4 y) {
  constexpr int unit = 1 << 14;
  const cv::v_float32x4 zero = cv::v_setzero_f32();
  x = cv::v_max(zero, cv::v_min(x, cv::v_setall_f32(static_cast<float>(shape.size.width) - 1.001F)));
  y = cv::v_max(zero, cv::v_min(y, cv::v_setall_f32(static_cast<float>(shape.size.height) - 1.001F)));
  const cv::v_float32x4 left = cv::v_cvt_f32(cv::v_trunc(x));
  const cv::v_float32x4 top = cv::v_cvt_f32(cv::v_trunc(y));
  std::array<std::int32_t, 4> place;
  cv::v_store(place.data(), cv::v_trunc(top * cv::v_setall_f32(static_cast<float>(shape.stride)) + left));
  std::array<std::int32_t, 4> upper;  // each a pixel and its right neighbour
  std::array<std::int32_t, 4> lower;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::int16_t* at = shape.weights + place[i];
    std::memcpy(&upper[i], at, sizeof upper[i]);
    std::memcpy(&lower[i], at + shape.stride, sizeof lower[i]);
  }
  // What either of them counts.
  const cv::v_int32x4 part = cv::v_round((x - left) * cv::v_setall_f32(unit));
  const cv::v_int16x8 parts = cv::v_reinterpret_as_s16((part << 16) + (cv::v_setall_s32(unit) - part));
  const auto along = [&](const std::array<std::int32_t, 4>& pairs) {
    const cv::v_int32x4 four(pairs[0], pairs[1], pairs[2], pairs[3]);
    return cv::v_cvt_f32(cv::v_dotprod(cv::v_reinterpret_as_s16(four), parts));
  };
  const cv::v_float32x4 above = along(upper);
  return (above + (y - top) * (along(lower) - above)) * cv::v_setall_f32(1.0F / unit);
}

// What is averaged over squares of pixels, with zeros around.
struct CoarseShape {
  std::vector<std::int16_t> weights;
  WeightedShape shape;

  CoarseShape(const WeightedShape& fine, int side) : shape(fine) {
    shape.size = {(fine.size.width + side - 1) / side + 2, (fine.size.height + side - 1) / side + 2};
    shape.stride = shape.size.width;
    weights.resize(static_cast<std::size_t>(shape.size.area()));
    std::vector<std::int32_t> sums(weights.size());
    for (int y = 0; y < fine.size.height; ++y) {
      std::int32_t* row = sums.data() + (y / side + 1) * shape.stride + 1;
      for (int x = 0; x < fine.size.width; ++x) row[x / side] += fine.weights[y * fine.stride + x];
    }
    const int pixels = side * side;
    std::ranges::transform(sums, weights.begin(),
                           [pixels](std::int32_t sum) { return static_cast<std::int16_t>(sum / pixels); });
    shape.weights = weights.data();
    const cv::Point2d half(0.5, 0.5);
    shape.centre = (fine.centre + half) / side + half;
    shape.spread = fine.spread * (1.0 / side);
  }
};

// How many pixels of the shape, along and across, are about one of a template: finer ones have nothing to be compared
// with, and rings miss where between them a sharp edge lies.
int pixels_a_template_pixel(const WeightedShape& shape) {
  return static_cast<int>(std::min(shape.spread(0, 0), shape.spread(1, 1)) / template_scale);
}

// Where the samples are taken, in standard deviations, ring by ring.
struct SamplePlaces {
  std::array<float, MarkSignature::rings * MarkSignature::turns> u;
  std::array<float, MarkSignature::rings * MarkSignature::turns> v;
};

const SamplePlaces& sample_places() {
  static const SamplePlaces places = [] {
    SamplePlaces out{};
    for (std::size_t ring = 0; ring < MarkSignature::rings; ++ring) {
      for (std::size_t i = 0; i < MarkSignature::turns; ++i) {
        const double angle = 2 * CV_PI * static_cast<double>(i) / MarkSignature::turns;
        out.u[ring * MarkSignature::turns + i] = static_cast<float>(ring_radii[ring] * std::cos(angle));
        out.v[ring * MarkSignature::turns + i] = static_cast<float>(ring_radii[ring] * std::sin(angle));
      }
    }
    return out;
  }();
  return places;
}

std::int32_t correlation(const MarkSignature& a, const MarkSignature& b, int turn) {
  constexpr int turns = MarkSignature::turns;
  std::int32_t sum = 0;
  for (int ring = 0; ring < MarkSignature::rings; ++ring) {
    const std::int16_t* p = a.samples.data() + ring * 2 * turns;
    const std::int16_t* q = b.samples.data() + ring * 2 * turns + turn;
    for (int i = 0; i < turns; ++i) sum += static_cast<std::int32_t>(p[i]) * q[i];
  }
  return sum;
}

MarkSignature sampled(const WeightedShape& shape) {
  MarkSignature out;
  const auto all = [](double value) { return cv::v_setall_f32(static_cast<float>(value)); };
  const cv::v_float32x4 xx = all(shape.spread(0, 0)), xy = all(shape.spread(0, 1)), yy = all(shape.spread(1, 1));
  const cv::v_float32x4 centre_x = all(shape.centre.x), centre_y = all(shape.centre.y);
  const SamplePlaces& places = sample_places();
  cv::v_int32x4 energy = cv::v_setzero_s32();
  for (std::size_t ring = 0; ring < MarkSignature::rings; ++ring) {
    const cv::v_float32x4 scale = all(weight_of(ring) / shape.full);
    std::int16_t* ring_samples = out.samples.data() + ring * 2 * MarkSignature::turns;
    const auto four = [&](std::size_t i) {
      const cv::v_float32x4 u = cv::v_load(places.u.data() + ring * MarkSignature::turns + i);
      const cv::v_float32x4 v = cv::v_load(places.v.data() + ring * MarkSignature::turns + i);
      return cv::v_round(sample(shape, centre_x + xx * u + xy * v, centre_y + xy * u + yy * v) * scale);
    };
    for (std::size_t i = 0; i < MarkSignature::turns; i += 8) {
      const cv::v_int16x8 eight = cv::v_pack(four(i), four(i + 4));
      energy += cv::v_dotprod(eight, eight);
      cv::v_store(ring_samples + i, eight);
      cv::v_store(ring_samples + i + MarkSignature::turns, eight);
    }
  }
  out.energy = cv::v_reduce_sum(energy);
  return out;
}

double error_of(const MarkSignature& a, const MarkSignature& b, std::int32_t best) {
  const double energy = std::sqrt(static_cast<double>(a.energy) * static_cast<double>(b.energy));
  return energy > 0 ? 2 - 2 * best / energy : 2;
}

}  // namespace

MarkSignature signature_of(const WeightedShape& shape) {
  const int side = pixels_a_template_pixel(shape);
  return side > 1 ? sampled(CoarseShape(shape, side).shape) : sampled(shape);
}

MarkSignature signature_of(const MarkTemplate& picture, double blur) {
  constexpr double finer = 16;  // than the picture's levels
  cv::Mat1s weights(template_size, template_size);
  std::ranges::transform(picture, weights.begin(), [](std::uint8_t level) { return finer * level; });
  const double sigma = template_scale * blur;
  if (blur > 0) cv::GaussianBlur(weights, weights, {}, sigma, sigma, cv::BORDER_CONSTANT);
  const double spread = template_scale * std::sqrt(1 + blur * blur);
  return signature_of({.weights = weights.ptr<std::int16_t>(0),
                       .stride = template_size,
                       .size = {template_size, template_size},
                       .centre = {template_size / 2.0, template_size / 2.0},
                       .spread = {spread, 0, 0, spread},
                       .full = 15 * finer});
}

std::array<float, MarkSignature::turns> reach_of(const MarkSignature& signature) {
  std::array<float, MarkSignature::turns> out{};
  for (std::size_t ring = 0; ring < MarkSignature::rings; ++ring) {
    const auto share = static_cast<float>(ring_shares[ring] / weight_of(ring));
    const std::int16_t* samples = signature.samples.data() + ring * 2 * MarkSignature::turns;
    for (std::size_t i = 0; i < out.size(); ++i) out[i] += share * static_cast<float>(samples[i]);
  }
  return out;
}

SignatureFit fit_signature(const MarkSignature& a, const MarkSignature& b) {
  constexpr int turns = MarkSignature::turns;
  std::int32_t best = std::numeric_limits<std::int32_t>::min();
  int best_turn = 0;
  const auto look_at = [&](int turn) {
    const std::int32_t here = correlation(a, b, turn);
    if (here <= best) return;
    best = here;
    best_turn = turn;
  };
  for (int turn = 0; turn < turns; turn += 3) look_at(turn);
  const int beside[] = {(best_turn + 1) % turns, (best_turn + turns - 1) % turns};
  for (const int turn : beside) look_at(turn);
  return {error_of(a, b, best), best_turn};
}

double signature_error(const MarkSignature& a, const MarkSignature& b) { return fit_signature(a, b).error; }

double signature_error(const MarkSignature& a, const MarkSignature& b, int most_turns, int about) {
  constexpr int turns = MarkSignature::turns;
  std::int32_t best = correlation(a, b, about);
  for (int turn = 1; turn <= most_turns; ++turn) {
    const std::int32_t further = correlation(a, b, (about + turn) % turns);
    best = std::max({best, further, correlation(a, b, (about + turns - turn) % turns)});
  }
  return error_of(a, b, best);
}

cv::Mat1f template_picture(const WeightedShape& shape) {
  const int side = pixels_a_template_pixel(shape);
  if (side > 1) return template_picture(CoarseShape(shape, side).shape);
  cv::Mat1f out(template_size, template_size);
  for (int y = 0; y < template_size; ++y) {
    for (int x = 0; x < template_size; ++x) {
      const double u = (x - template_size / 2.0) / template_scale;
      const double v = (y - template_size / 2.0) / template_scale;
      const double at_x = shape.centre.x + shape.spread(0, 0) * u + shape.spread(0, 1) * v;
      const double at_y = shape.centre.y + shape.spread(1, 0) * u + shape.spread(1, 1) * v;
      out(y, x) = sample(shape, static_cast<float>(at_x), static_cast<float>(at_y)) / static_cast<float>(shape.full);
    }
  }
  return out;
}

MarkTemplate template_from_picture(const cv::Mat1f& picture) {
  MarkTemplate out{};
  std::transform(picture.begin(), picture.end(), out.begin(), [](float weight) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(weight, 0.F, 1.F) * 15));
  });
  return out;
}

std::string template_to_text(const MarkTemplate& picture) {
  std::string text;
  text.reserve(picture.size());
  for (const std::uint8_t level : picture) text += "0123456789abcdef"[level];
  return text;
}

Result<MarkTemplate> template_from_text(std::string_view text) {
  MarkTemplate out{};
  if (text.size() != out.size()) return fail("bad-template", "a template has 1024 hexadecimal digits");
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::size_t level = std::string_view("0123456789abcdef").find(text[i]);
    if (level == std::string_view::npos) return fail("bad-template", "a template has 1024 hexadecimal digits");
    out[i] = static_cast<std::uint8_t>(level);
  }
  return out;
}

}  // namespace pizarra
