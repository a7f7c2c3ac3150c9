#pragma once

// What shape a mark has, whatever its place, size, turn and view: its grey weights sampled on rings after the mark's
// second moments have been made those of a circle (which undoes size and the foreshortening of a yawed face). Two
// signatures are compared over all turns.
//
// The square template of a learned object is the same normalised shape as a small picture; a signature can be taken
// from it again, so that the template is all that need be kept.
//
//   double error = signature_error(signature_of(seen.shape()), signature_of(learned.picture));  // 0 alike, about 2
//   apart

#include <array>
#include <cstdint>
#include <opencv2/core.hpp>
#include <string>

#include "lisp/result.hpp"

namespace pizarra {

// The grey weights of a mark (1 mark, 0 ground) around its centre, both in px of `weights`.
struct WeightedShape {
  cv::Mat1f weights;
  cv::Point2d centre;
  cv::Matx22d spread;  // the symmetric square root of its covariance, px
};

inline constexpr int template_size = 32;     // px
inline constexpr double template_scale = 5;  // px a standard deviation

// Grey levels 0..15, row by row.
using MarkTemplate = std::array<std::uint8_t, template_size * template_size>;

struct MarkSignature {
  static constexpr int rings = 7;
  static constexpr int turns = 48;
  // One more turn behind the first, so that a turned signature is a run of neighbours.
  std::array<std::int16_t, rings * 2 * turns> samples{};
  std::int64_t energy = 0;
};

MarkSignature signature_of(const WeightedShape& shape);
MarkSignature signature_of(const MarkTemplate& picture);

// The squared difference over the mean energy at the best turn.
double signature_error(const MarkSignature& a, const MarkSignature& b);

// The normalised shape as a picture with weights 0..1.
cv::Mat1f template_picture(const WeightedShape& shape);
MarkTemplate template_from_picture(const cv::Mat1f& picture);

// One hexadecimal digit a pixel, and back; failure `bad-template`.
std::string template_to_text(const MarkTemplate& picture);
Result<MarkTemplate> template_from_text(std::string_view text);

}  // namespace pizarra
