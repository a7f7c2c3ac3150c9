#include "agents/vision/objects/shape_doubt.hpp"

#include <algorithm>
#include <cmath>

namespace pizarra::vision {
namespace {

// All that follows was measured of the five marks in 120,000 of the bench's scenes (30 seeds), and of 112,500 marks
// turned away by up to 45 degrees.
//
// How far a picture may be off, and an outline, as a share of what is not round about it. The causes are blur, a
// sharper image than it was learned from, and perspective. A light mark lies on something dark that ends near it: the
// blurred border of that adds to both. Noise adds to the picture's error too, but no more of it is let pass: one mark
// in a thousand differs by more, and what is as small, blurred and noisy, and differs by as much, is another thing as a
// rule.
struct Allowance {
  double picture;
  double outline_share;
};
constexpr Allowance of_dark{0.065, 0.04};
constexpr Allowance of_light{0.1, 0.06};
// An outline may also differ, in squared standard deviations of the mark, by the pixels' phase, and by the square of
// the noise, the less the more pixels there are. Of a small mark neighbouring samples share pixels, so that its outline
// is less noisy than that.
constexpr double outline_slack = 0.0004;
constexpr double outline_noise = 25;  // px^2
constexpr double least_sampled_px = 3.5;
constexpr double least_noise = 0.01;  // of the contrast
// By less than this, blurred, an outline may differ that nobody learned: an octagon's from a circle. However much noise
// may make, what differs by more is not known for certain; and by one wave alone less of it counts as much as by all.
constexpr double least_other = 0.0015;
constexpr double wave_share = 0.5;
// A learned mark of which blur leaves so much in the middle is solid there. A ring whose hole blur fills is a disc but
// for this: its middle is lighter than its rim by more than uneven print, and noise, make of a solid one.
constexpr double solid_middle = 0.9;
constexpr double middle_slack = 0.1;
constexpr double middle_noise = 0.6;

// By how much the mark's middle is lighter than that of the sample, as a part of what a solid one's may be.
double middle_doubt(const SeenMark& mark, const LearnedSample& sample, double noise) {
  const float learned = sample.signatures.back().unturned().middle;
  if (learned < solid_middle) return 0;
  return std::max(0.0, (learned - mark.signature.middle) / (middle_slack + middle_noise * noise));
}

double noise_in_outline(const SeenMark& mark, double level_noise) {
  const double pixels = mark.height_px * std::max(mark.height_px, least_sampled_px);
  return outline_noise * level_noise * level_noise / pixels;
}

}  // namespace

ShapeDoubt shape_doubt(const SeenMark& mark, const MarkMatch& match) {
  if (mark.tag) return {mark.tag_doubt, mark.tag_doubt};
  if (match.sample == nullptr) return {};
  const Allowance& allowed = mark.tone == MarkTone::dark ? of_dark : of_light;
  const double contrast = std::max(1.0, std::abs(mark.mark_level - mark.ground_level));
  const double level_noise = std::max(least_noise, mark.noise / contrast);
  const auto part = static_cast<std::size_t>(match.turn % TurnedSignatures::parts);
  const MarkOutline& learned = match.sample->outlines[part];
  // Blur changes a tilted mark more along the direction that the tilt shortens.
  const double shortened = mark.flattened ? std::min(1.0, mark.slimness / match.sample->slimness) : 1;
  const double ever = allowed.outline_share * learned.power() / shortened;
  const double by_noise = outline_slack + noise_in_outline(mark, level_noise);
  const OutlineDifference difference =
      outline_difference(outline_of(mark.signature), learned, widest_blur_px / mark.height_px);
  // Noise makes a little of both; another shape that passes by one of them alone is off by the other as well.
  const double shape = std::hypot(match.error / allowed.picture, difference.in_all / (ever + by_noise));
  const double doubt = std::max(shape, middle_doubt(mark, *match.sample, level_noise));
  return {doubt, std::max(doubt, difference.in_one / (ever + wave_share * std::min(by_noise, least_other)))};
}

}  // namespace pizarra::vision
