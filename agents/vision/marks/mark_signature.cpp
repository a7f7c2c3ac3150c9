#include "agents/vision/marks/mark_signature.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <opencv2/core/hal/intrin.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace pizarra::vision {
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

// sample() of four places at once, given in px; times `scale`, rounded. The shape's part in it is prepared once.
class FourSampler {
 public:
  explicit FourSampler(const WeightedShape& shape)
      : weights_(shape.weights),
        stride_(shape.stride),
        stride_of_all_(cv::v_setall_f32(static_cast<float>(shape.stride))),
        last_x_(cv::v_setall_f32(static_cast<float>(shape.size.width) - 1.001F)),
        last_y_(cv::v_setall_f32(static_cast<float>(shape.size.height) - 1.001F)) {}

  cv::v_int32x4 at(cv::v_float32x4 x, cv::v_float32x4 y, double scale) const {
    const cv::v_float32x4 zero = cv::v_setzero_f32();
    x = cv::v_max(zero, cv::v_min(x, last_x_));
    y = cv::v_max(zero, cv::v_min(y, last_y_));
    const cv::v_float32x4 left = cv::v_cvt_f32(cv::v_trunc(x));
    const cv::v_float32x4 top = cv::v_cvt_f32(cv::v_trunc(y));
    std::array<std::int32_t, 4> place;
    cv::v_store(place.data(), cv::v_trunc(top * stride_of_all_ + left));
    std::array<std::int32_t, 4> upper;  // each a pixel and its right neighbour
    std::array<std::int32_t, 4> lower;
    for (std::size_t i = 0; i < 4; ++i) {
      const std::int16_t* at = weights_ + place[i];
      std::memcpy(&upper[i], at, sizeof upper[i]);
      std::memcpy(&lower[i], at + stride_, sizeof lower[i]);
    }
    // What either of them counts.
    const cv::v_int32x4 part = cv::v_round((x - left) * cv::v_setall_f32(unit));
    const cv::v_int16x8 parts = cv::v_reinterpret_as_s16((part << 16) + (cv::v_setall_s32(unit) - part));
    const auto along = [&](const std::array<std::int32_t, 4>& pairs) {
      const cv::v_int32x4 four(pairs[0], pairs[1], pairs[2], pairs[3]);
      return cv::v_cvt_f32(cv::v_dotprod(cv::v_reinterpret_as_s16(four), parts));
    };
    const cv::v_float32x4 above = along(upper);
    const cv::v_float32x4 value = above + (y - top) * (along(lower) - above);
    return cv::v_round(value * cv::v_setall_f32(static_cast<float>(scale) / unit));
  }

 private:
  static constexpr int unit = 1 << 14;
  const std::int16_t* weights_;
  int stride_;
  cv::v_float32x4 stride_of_all_;
  cv::v_float32x4 last_x_;
  cv::v_float32x4 last_y_;
};

// A shape averaged over squares of pixels, with zeros around.
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

// In these directions, so many standard deviations from its centre, a mark's middle is looked at.
constexpr double middle_radius = 0.4;
constexpr int middle_places = 4;

// The mean there, as a part of what is full.
float middle_of(const WeightedShape& shape) {
  float sum = 0;
  for (int i = 0; i < middle_places; ++i) {
    const double angle = 2 * CV_PI * i / middle_places;
    const cv::Vec2d away = shape.spread * cv::Vec2d(middle_radius * std::cos(angle), middle_radius * std::sin(angle));
    sum += sample(shape, static_cast<float>(shape.centre.x + away[0]), static_cast<float>(shape.centre.y + away[1]));
  }
  return sum / middle_places / static_cast<float>(shape.full);
}

// Where the samples are taken, in standard deviations, ring by ring.
struct SamplePlaces {
  std::array<float, MarkSignature::rings * MarkSignature::turns> u;
  std::array<float, MarkSignature::rings * MarkSignature::turns> v;

  explicit SamplePlaces(double turned_steps) {
    for (std::size_t ring = 0; ring < MarkSignature::rings; ++ring) {
      for (std::size_t i = 0; i < MarkSignature::turns; ++i) {
        const double angle = 2 * CV_PI * (static_cast<double>(i) + turned_steps) / MarkSignature::turns;
        u[ring * MarkSignature::turns + i] = static_cast<float>(ring_radii[ring] * std::cos(angle));
        v[ring * MarkSignature::turns + i] = static_cast<float>(ring_radii[ring] * std::sin(angle));
      }
    }
  }
};

// Of every ring, or of every second one, by which the turn is found faster.
template <int ring_step = 1>
std::int32_t correlation(const MarkSignature& a, const MarkSignature& b, int turn) {
  constexpr int turns = MarkSignature::turns;
  cv::v_int32x4 sum = cv::v_setzero_s32();
  for (int ring = ring_step - 1; ring < MarkSignature::rings; ring += ring_step) {
    const std::int16_t* p = a.samples.data() + ring * 2 * turns;
    const std::int16_t* q = b.samples.data() + ring * 2 * turns + turn;
    for (int i = 0; i < turns; i += 8) sum = cv::v_dotprod(cv::v_load(p + i), cv::v_load(q + i), sum);
  }
  return cv::v_reduce_sum(sum);
}

MarkSignature sampled(const WeightedShape& shape, const SamplePlaces& places) {
  MarkSignature out;
  const FourSampler sampler(shape);
  const auto all = [](double value) { return cv::v_setall_f32(static_cast<float>(value)); };
  const cv::v_float32x4 xx = all(shape.spread(0, 0)), xy = all(shape.spread(0, 1)), yy = all(shape.spread(1, 1));
  const cv::v_float32x4 centre_x = all(shape.centre.x), centre_y = all(shape.centre.y);
  cv::v_int32x4 energy = cv::v_setzero_s32();
  for (std::size_t ring = 0; ring < MarkSignature::rings; ++ring) {
    const double scale = weight_of(ring) / shape.full;
    std::int16_t* ring_samples = out.samples.data() + ring * 2 * MarkSignature::turns;
    const auto four = [&](std::size_t i) {
      const cv::v_float32x4 u = cv::v_load(places.u.data() + ring * MarkSignature::turns + i);
      const cv::v_float32x4 v = cv::v_load(places.v.data() + ring * MarkSignature::turns + i);
      return sampler.at(centre_x + xx * u + xy * v, centre_y + xy * u + yy * v, scale);
    };
    for (std::size_t i = 0; i < MarkSignature::turns; i += 8) {
      cv::v_int32x4 halves[2];
      for (std::size_t half = 0; half < 2; ++half) halves[half] = four(i + 4 * half);
      const cv::v_int16x8 eight = cv::v_pack(halves[0], halves[1]);
      energy += cv::v_dotprod(eight, eight);
      cv::v_store(ring_samples + i, eight);
      cv::v_store(ring_samples + i + MarkSignature::turns, eight);
    }
  }
  out.length = std::sqrt(cv::v_reduce_sum(energy));
  out.middle = middle_of(shape);
  return out;
}

double error_at(const MarkSignature& a, const MarkSignature& b, int turn) {
  const double lengths = a.length * b.length;
  return lengths > 0 ? 2 - 2 * correlation(a, b, turn) / lengths : 2;
}

// At any turn, also one below 0 or beyond the last.
SignatureFit fit_at(const MarkSignature& seen, const TurnedSignatures& learned, int turn) {
  constexpr int parts = TurnedSignatures::parts;
  const int at = (turn + TurnedSignatures::turns) % TurnedSignatures::turns;
  return {error_at(seen, learned.by_part[static_cast<std::size_t>(at % parts)], at / parts), at};
}

SignatureFit better_beside(const MarkSignature& seen, const TurnedSignatures& learned, SignatureFit fit, int away) {
  const SignatureFit beside[] = {fit, fit_at(seen, learned, fit.turn - away), fit_at(seen, learned, fit.turn + away)};
  return *std::ranges::min_element(beside, {}, &SignatureFit::error);
}

// From a turn on to better ones, in ever smaller steps.
SignatureFit refined(const MarkSignature& seen, const TurnedSignatures& learned, int turn, int away) {
  SignatureFit fit = fit_at(seen, learned, turn);
  for (; away > 0; away /= 2) fit = better_beside(seen, learned, fit, away);
  return fit;
}

WeightedShape as_shape(const cv::Mat1s& weights, double spread, double full) {
  return {.weights = weights.ptr<std::int16_t>(0),
          .stride = template_size,
          .size = {template_size, template_size},
          .centre = {template_size / 2.0, template_size / 2.0},
          .spread = {spread, 0, 0, spread},
          .full = full};
}

}  // namespace

MarkSignature signature_of(const WeightedShape& shape) {
  static const SamplePlaces places(0);
  const int side = pixels_a_template_pixel(shape);
  return side > 1 ? sampled(CoarseShape(shape, side).shape, places) : sampled(shape, places);
}

TurnedSignatures turned_signatures_of(const MarkTemplate& picture, double blur) {
  constexpr double finer = 16;  // than the picture's levels
  cv::Mat1s weights(template_size, template_size);
  std::ranges::transform(picture, weights.begin(), [](std::uint8_t level) { return finer * level; });
  const double sigma = template_scale * blur;
  if (blur > 0) cv::GaussianBlur(weights, weights, {}, sigma, sigma, cv::BORDER_CONSTANT);
  const WeightedShape shape = as_shape(weights, template_scale * std::sqrt(1 + blur * blur), 15 * finer);
  TurnedSignatures out;
  for (std::size_t part = 0; part < out.by_part.size(); ++part) {
    out.by_part[part] = sampled(shape, SamplePlaces(static_cast<double>(part) / TurnedSignatures::parts));
  }
  return out;
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

// Of the whole steps the best by some rings, then by all between it and those beside it.
SignatureFit fit_signature(const MarkSignature& seen, const TurnedSignatures& learned) {
  std::array<std::int32_t, MarkSignature::turns> common;
  for (int turn = 0; turn < MarkSignature::turns; ++turn) {
    common[static_cast<std::size_t>(turn)] = correlation<2>(seen, learned.unturned(), turn);
  }
  const auto best = static_cast<int>(std::ranges::max_element(common) - common.begin());
  return refined(seen, learned, TurnedSignatures::parts * best, TurnedSignatures::parts / 2);
}

SignatureFit fit_signature(const MarkSignature& seen, const TurnedSignatures& learned, int about) {
  return refined(seen, learned, about, TurnedSignatures::parts / 2);
}

double signature_error(const MarkSignature& seen, const TurnedSignatures& learned, int about) {
  return better_beside(seen, learned, fit_at(seen, learned, about), 1).error;
}

double signature_error(const MarkSignature& a, const MarkSignature& b) {
  return std::min({error_at(a, b, 0), error_at(a, b, 1), error_at(a, b, MarkSignature::turns - 1)});
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

}  // namespace pizarra::vision
