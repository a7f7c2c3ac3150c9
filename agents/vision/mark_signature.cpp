#include "agents/vision/mark_signature.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pizarra {
namespace {

// In standard deviations; a circle ends at 2, a square between 1.7 and 2.4, a triangle's corners at 2.8.
constexpr std::array<double, MarkSignature::rings> ring_radii = {0.5, 1.1, 1.5, 1.8, 2.1, 2.4, 2.7};
constexpr double quantum = 64;

double bilinear(const cv::Mat1f& image, double x, double y) {
  const double left = std::floor(x);
  const double top = std::floor(y);
  if (left < 0 || top < 0 || left + 1 >= image.cols || top + 1 >= image.rows) return 0;
  const float* upper = image.ptr<float>(static_cast<int>(top)) + static_cast<int>(left);
  const float* lower = image.ptr<float>(static_cast<int>(top) + 1) + static_cast<int>(left);
  const double fx = x - left;
  const double fy = y - top;
  return (upper[0] * (1 - fx) + upper[1] * fx) * (1 - fy) + (lower[0] * (1 - fx) + lower[1] * fx) * fy;
}

double sample(const WeightedShape& shape, double u, double v) {
  return bilinear(shape.weights, shape.centre.x + shape.spread(0, 0) * u + shape.spread(0, 1) * v,
                  shape.centre.y + shape.spread(1, 0) * u + shape.spread(1, 1) * v);
}

struct Direction {
  double cosine;
  double sine;
};

const std::array<Direction, MarkSignature::turns>& directions() {
  static const auto table = [] {
    std::array<Direction, MarkSignature::turns> out{};
    for (int i = 0; i < MarkSignature::turns; ++i) {
      const double angle = 2 * CV_PI * i / MarkSignature::turns;
      out[static_cast<std::size_t>(i)] = {std::cos(angle), std::sin(angle)};
    }
    return out;
  }();
  return table;
}

}  // namespace

MarkSignature signature_of(const WeightedShape& shape) {
  MarkSignature out;
  std::size_t at = 0;
  for (const double radius : ring_radii) {
    const double weight = quantum * std::sqrt(radius);
    for (const Direction& direction : directions()) {
      const double value = sample(shape, radius * direction.cosine, radius * direction.sine);
      const auto rounded = static_cast<std::int16_t>(std::lround(std::clamp(value, -0.5, 1.5) * weight));
      out.samples[at] = rounded;
      out.samples[at + MarkSignature::turns] = rounded;
      out.energy += static_cast<std::int64_t>(rounded) * rounded;
      ++at;
    }
    at += MarkSignature::turns;
  }
  return out;
}

MarkSignature signature_of(const MarkTemplate& picture) {
  WeightedShape shape;
  shape.weights = cv::Mat1f(template_size, template_size);
  std::transform(picture.begin(), picture.end(), shape.weights.begin(),
                 [](std::uint8_t level) { return level / 15.F; });
  shape.centre = {template_size / 2.0, template_size / 2.0};
  shape.spread = {template_scale, 0, 0, template_scale};
  return signature_of(shape);
}

double signature_error(const MarkSignature& a, const MarkSignature& b) {
  constexpr int turns = MarkSignature::turns;
  std::int32_t best = std::numeric_limits<std::int32_t>::min();
  for (int turn = 0; turn < turns; ++turn) {
    std::int32_t sum = 0;
    for (int ring = 0; ring < MarkSignature::rings; ++ring) {
      const std::int16_t* p = a.samples.data() + ring * 2 * turns;
      const std::int16_t* q = b.samples.data() + ring * 2 * turns + turn;
      for (int i = 0; i < turns; ++i) sum += static_cast<std::int32_t>(p[i]) * q[i];
    }
    best = std::max(best, sum);
  }
  const auto total = static_cast<double>(a.energy + b.energy);
  return total > 0 ? 2 * (total - 2.0 * best) / total : 2;
}

cv::Mat1f template_picture(const WeightedShape& shape) {
  cv::Mat1f out(template_size, template_size);
  for (int y = 0; y < template_size; ++y) {
    for (int x = 0; x < template_size; ++x) {
      const double u = (x - template_size / 2.0) / template_scale;
      const double v = (y - template_size / 2.0) / template_scale;
      out(y, x) = static_cast<float>(sample(shape, u, v));
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
