#include "agents/vision/objects/mark_match.hpp"

#include <algorithm>
#include <cmath>

namespace pizarra::vision {
namespace {

constexpr double impossible = std::numeric_limits<double>::infinity();
const MarkMatch same_tag{.error = 0, .shape_error = 0};
constexpr double least_slimness = 0.55;
// For marks that are seen as from the front, however far they are tilted. Tilted by 55 degrees and seen 24 degrees
// beside the camera's axis they look slimmer still; few pixels lie across such a one, and much is a little like it.
constexpr double least_flattened = 0.3;
constexpr double least_flattened_if_alike = 0.2;
// Of roundness, while samples spread as little as the frames of one do in good light; less where they spread more.
constexpr double roundness_weight = 0.25;
constexpr double ordinary_spread = 0.01;
// With less error than this a mark need not be compared with what blur would make of the object.
constexpr double clear_error = 0.01;

// By how much bolder a print was learned than a faint one is seen. Of 2,594 photographed marks without a reflection
// none lay more than log(1.6) below the others; blur makes small marks fainter.
const double most_fainter = std::log(2);

double weight_of_roundness(const LearnedObject& object) {
  return roundness_weight * ordinary_spread / std::max(ordinary_spread, object.roundness_spread);
}

double roundness_error(const SeenMark& mark, const LearnedSample& sample, double weight) {
  return weight * std::abs(mark.roundness / sample.roundness - 1);
}

// Near the last turn first: where that hardly fits, the mark turned faster or is another.
SignatureFit sharp_fit(const SeenMark& mark, const LearnedSample& sample, std::optional<int> last_turn) {
  const TurnedSignatures& learned = sample.signatures.front();
  if (last_turn) {
    const SignatureFit near = fit_signature(mark.signature, learned, *last_turn);
    if (near.error < recognition_threshold / 2) return near;
  }
  return fit_signature(mark.signature, learned);
}

// How many times as large as the camera it was learned with the one that shows it shows everything.
double enlarged(const SeenMark& mark, const LearnedSample& sample) {
  return mark.focal_px > 0 && sample.focal_px > 0 ? mark.focal_px / sample.focal_px : 1;
}

bool has_size(const SeenMark& mark, const LearnedSample& sample) {
  const double scale = scale_of(mark, sample);
  return scale >= least_scale && scale <= most_scale;
}

// Of shapes, whatever their size.
MarkMatch shape_match(const SeenMark& mark, const LearnedSample& sample, double weight,
                      std::optional<int> last_turn = {}) {
  const double slimmest = mark.flattened ? least_flattened_if_alike : least_slimness;
  if (mark.tone != sample.tone || mark.slimness < slimmest * sample.slimness) return {};
  // The parameters first: where they differ too much the shapes need not be compared.
  const double roundness = roundness_error(mark, sample, weight);
  if (roundness > recognition_threshold) return {};
  const SignatureFit sharp = sharp_fit(mark, sample, last_turn);
  MarkMatch best{sharp.error + roundness, sharp.error, 0, sharp.turn, &sample};
  for (std::size_t i = 1; i < sample.blurs.size() && best.shape_error > clear_error; ++i) {
    if (sample.blurs[i] * mark.height_px > widest_blur_px) break;
    // Blur turns nothing.
    const double error = signature_error(mark.signature, sample.signatures[i], sharp.turn);
    if (error < best.shape_error) best = {error + roundness, error, i, sharp.turn, &sample};
  }
  const bool is_slim = mark.flattened && mark.slimness < least_flattened * sample.slimness;
  return is_slim && best.error > recognition_threshold / 2 ? MarkMatch() : best;
}

bool are_shapes(const SeenMark& mark, const LearnedSample& sample) { return !mark.tag && !sample.tag; }

// Of match(sample) the nearest.
MarkMatch nearest(const LearnedObject& object, auto match) {
  MarkMatch best;
  for (const LearnedSample& sample : object.samples) {
    const MarkMatch one = match(sample);
    if (one.error < best.error) best = one;
  }
  return best;
}

}  // namespace

double scale_of(const SeenMark& mark, const LearnedSample& sample) {
  const double as_learned = 1 / enlarged(mark, sample);
  if (mark.flattened) {
    // No tilt shortens the longer axis.
    const double longer =
        std::sqrt(mark.width_px * mark.width_px + mark.height_px * mark.height_px) / std::hypot(1, mark.slimness);
    return as_learned * longer / sample.height_px;
  }
  const double by_height = as_learned * mark.height_px / sample.height_px;
  if (sample.slimness >= least_round) return by_height;
  const double by_area = as_learned * std::sqrt(mark.area_px / sample.area_px);
  return std::abs(std::log(by_height)) < std::abs(std::log(by_area)) ? by_height : by_area;
}

double spread_scale_of(const SeenMark& mark, const LearnedSample& sample) {
  const double larger = mark.roundness * mark.area_px / (sample.roundness * sample.area_px);
  return std::sqrt(larger) / enlarged(mark, sample);
}

bool is_faint(const SeenMark& mark, const LearnedObject& object) {
  return print_contrast(mark) + most_fainter < object.contrast();
}

double roundness_error(const SeenMark& mark, const LearnedObject& object) {
  const double weight = weight_of_roundness(object);
  double least = impossible;
  for (const LearnedSample& sample : object.samples) least = std::min(least, roundness_error(mark, sample, weight));
  return least;
}

MarkMatch match_of(const SeenMark& mark, const LearnedObject& object, std::optional<int> last_turn) {
  const double weight = weight_of_roundness(object);
  return nearest(object, [&](const LearnedSample& sample) -> MarkMatch {
    if (!are_shapes(mark, sample)) return mark.tag == sample.tag ? same_tag : MarkMatch();
    return has_size(mark, sample) ? shape_match(mark, sample, weight, last_turn) : MarkMatch();
  });
}

MarkMatch match_of_another_size(const SeenMark& mark, const LearnedObject& object) {
  const double weight = weight_of_roundness(object);
  return nearest(object, [&](const LearnedSample& sample) -> MarkMatch {
    if (!are_shapes(mark, sample) || has_size(mark, sample)) return {};
    return shape_match(mark, sample, weight);
  });
}

double likeness_error(const LearnedObject& a, const LearnedObject& b) {
  double best = impossible;
  for (const LearnedSample& one : a.samples) {
    for (const LearnedSample& other : b.samples) {
      if (one.tone != other.tone || one.tag || other.tag) continue;
      const double roundness = roundness_weight * std::abs(one.roundness / other.roundness - 1);
      const SignatureFit fit = fit_signature(one.signatures.front().unturned(), other.signatures.front());
      best = std::min(best, fit.error + roundness);
    }
  }
  return best;
}

}  // namespace pizarra::vision
