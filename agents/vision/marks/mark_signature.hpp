#pragma once

// What shape a mark has, whatever its place, size, turn and view: its weights sampled on rings after the mark's second
// moments have been made those of a circle (which undoes size and the foreshortening of a yawed face). Two signatures
// are compared over all turns, or, where it is known how the mark is turned, over a few.
//
// The square template of a learned object is the same normalised shape as a small picture; a signature can be taken
// from it again, so that the template is all that need be kept.
//
//   double error = signature_error(seen.signature, signature_of(learned.picture));  // 0 alike, 2 nothing in common

#include <array>
#include <cstdint>
#include <opencv2/core.hpp>
#include <string>

#include "lisp/result.hpp"

namespace pizarra {

// The weights of a mark, row by row, `full` where the mark is and 0 on the ground; 0 along the border of the picture.
struct WeightedShape {
  const std::int16_t* weights;
  int stride;
  cv::Size size;
  cv::Point2d centre;  // px
  cv::Matx22d spread;  // the symmetric square root of its covariance, px
  double full;
};

inline constexpr int template_size = 32;     // px
inline constexpr double template_scale = 5;  // px a standard deviation

// Grey levels 0..15, row by row.
using MarkTemplate = std::array<std::uint8_t, template_size * template_size>;

struct MarkSignature {
  static constexpr int rings = 6;
  static constexpr int turns = 40;
  // Every ring twice over, so that a turned one is a run of neighbours.
  std::array<std::int16_t, rings * 2 * turns> samples{};
  std::int64_t energy = 0;
};

MarkSignature signature_of(const WeightedShape& shape);
// `blur`: how much more blurred than the picture the mark is to be seen, in its standard deviations.
MarkSignature signature_of(const MarkTemplate& picture, double blur = 0);

// How far the shape reaches, turn by turn, in standard deviations from half of one on. Blur hardly changes it: what it
// takes away within the edge it adds beyond.
std::array<float, MarkSignature::turns> reach_of(const MarkSignature& signature);

// Two minus twice the correlation at the best turn: the best of every third one, or beside it.
struct SignatureFit {
  double error;
  int turn;  // so many steps of 9 degrees
};
SignatureFit fit_signature(const MarkSignature& a, const MarkSignature& b);
double signature_error(const MarkSignature& a, const MarkSignature& b);
// The same, over turns of at most `most_turns` steps either way from `about`.
double signature_error(const MarkSignature& a, const MarkSignature& b, int most_turns, int about = 0);

// The normalised shape as a picture with weights 0..1.
cv::Mat1f template_picture(const WeightedShape& shape);
MarkTemplate template_from_picture(const cv::Mat1f& picture);

// One hexadecimal digit a pixel, and back; failure `bad-template`.
std::string template_to_text(const MarkTemplate& picture);
Result<MarkTemplate> template_from_text(std::string_view text);

}  // namespace pizarra
