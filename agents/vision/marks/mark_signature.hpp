#pragma once

// The shape of a mark, whatever its place, size, turn and view. The mark's second moments are made those of a circle,
// which undoes size and the foreshortening of a yawed face. Then its weights are sampled on rings.
//
// The square template of a learned object is the same normalised shape as a small picture; signatures can be taken
// from it again, so that the template is all that need be kept. A seen mark has few samples; a learned shape is sampled
// at finer turns, for a point of a star or the bar of a T is narrower than from one sample to the next.
//
//   SignatureFit fit = fit_signature(seen.signature, turned_signatures_of(learned.picture));
//   fit.error;                                          // 0 alike, 2 nothing in common

#include <array>
#include <cstdint>
#include <opencv2/core.hpp>
#include <string>

#include "lisp/result.hpp"

namespace pizarra::vision {

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
  double length = 0;  // the root of their squares' sum
  float middle = 0;   // within the rings, 1 where it is full
};

// A shape turned by parts of the step between two samples, too.
struct TurnedSignatures {
  static constexpr int parts = 4;
  static constexpr int turns = parts * MarkSignature::turns;
  std::array<MarkSignature, parts> by_part;

  const MarkSignature& unturned() const { return by_part.front(); }
};

MarkSignature signature_of(const WeightedShape& shape);
// `blur`: how much more blurred than the picture the mark is to be seen, in its standard deviations.
TurnedSignatures turned_signatures_of(const MarkTemplate& picture, double blur = 0);

// How far the shape reaches, turn by turn, in standard deviations from half of one on. Blur hardly changes it: what it
// takes away within the edge it adds beyond.
std::array<float, MarkSignature::turns> reach_of(const MarkSignature& signature);

// Two minus twice the correlation at the best turn.
struct SignatureFit {
  double error;
  int turn;  // of TurnedSignatures::turns
};
SignatureFit fit_signature(const MarkSignature& seen, const TurnedSignatures& learned);
// The same, less than a step between samples from `about`.
SignatureFit fit_signature(const MarkSignature& seen, const TurnedSignatures& learned, int about);
// At `about` or the turns beside it.
double signature_error(const MarkSignature& seen, const TurnedSignatures& learned, int about);
// Of two that are seen turned alike, to a step between two samples.
double signature_error(const MarkSignature& a, const MarkSignature& b);

// The normalised shape as a picture with weights 0..1.
cv::Mat1f template_picture(const WeightedShape& shape);
MarkTemplate template_from_picture(const cv::Mat1f& picture);

// One hexadecimal digit a pixel, and back; failure `bad-template`.
std::string template_to_text(const MarkTemplate& picture);
Result<MarkTemplate> template_from_text(std::string_view text);

}  // namespace pizarra::vision
