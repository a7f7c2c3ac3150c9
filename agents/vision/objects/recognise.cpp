#include "agents/vision/objects/recognise.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pizarra {
namespace {

constexpr double impossible = std::numeric_limits<double>::infinity();
constexpr double least_slimness = 0.55;
// Of roundness, while samples spread as little as the frames of one do in good light; less where they spread more.
constexpr double roundness_weight = 0.25;
constexpr double ordinary_spread = 0.01;
// With less error than this a mark need not be compared with what blur would make of the object.
constexpr double clear_error = 0.01;
// More than this no lens that is nearly focused blurs.
constexpr double widest_blur_px = 2.2;
// So much error, and so much doubt, make something e times less likely.
constexpr double error_scale = 0.01;
constexpr double doubt_scale = 1.0 / 6;
// What an outline may differ by, in squared standard deviations of the mark: by the pixels' phase; as a part of what is
// not round about it, by blur and perspective; and by noise, which is the less the more pixels there are.
constexpr double outline_slack = 0.0003;
constexpr double outline_share = 0.04;
constexpr double outline_noise = 25;
constexpr double least_noise = 0.01;  // of the contrast

double weight_of_roundness(const LearnedObject& object) {
  return roundness_weight * ordinary_spread / std::max(ordinary_spread, object.roundness_spread);
}

double sample_error(const SeenMark& mark, const LearnedSample& sample, double weight) {
  if (mark.tag || sample.tag) return mark.tag == sample.tag ? 0 : impossible;
  if (mark.tone != sample.tone || mark.slimness < least_slimness * sample.slimness) return impossible;
  const double scale = mark.height_px / sample.height_px;
  if (scale < 0.5 || scale > 1.8) return impossible;
  // The parameters first: where they differ too much the shapes need not be compared.
  const double roundness = weight * std::abs(mark.roundness / sample.roundness - 1);
  if (roundness > recognition_threshold) return impossible;
  double best = impossible;
  for (std::size_t i = 0; i < sample.blurs.size() && best > clear_error; ++i) {
    if (sample.blurs[i] * mark.height_px > widest_blur_px) break;
    best = std::min(best, signature_error(mark.signature, sample.signatures[i]));
  }
  return best + roundness;
}

}  // namespace

double recognition_error(const SeenMark& mark, const LearnedObject& object) {
  const double weight = weight_of_roundness(object);
  double best = impossible;
  for (const LearnedSample& sample : object.samples) best = std::min(best, sample_error(mark, sample, weight));
  return best;
}

double outline_doubt(const SeenMark& mark, const LearnedObject& object) {
  if (mark.tag) return 0;
  const MarkOutline seen = outline_of(mark.signature);
  const double contrast = std::max(1.0, std::abs(mark.mark_level - mark.ground_level));
  const double noise = std::max(least_noise, mark.noise / contrast) / mark.height_px;
  double least = impossible;
  for (const LearnedSample& sample : object.samples) {
    if (sample.tag || sample.tone != mark.tone) continue;
    const double allowed = outline_slack + outline_share * sample.outline.power() + outline_noise * noise * noise;
    least = std::min(least, outline_error(seen, sample.outline) / allowed);
  }
  return least;
}

double likeness_error(const LearnedObject& a, const LearnedObject& b) {
  double best = impossible;
  for (const LearnedSample& one : a.samples) {
    for (const LearnedSample& other : b.samples) {
      if (one.tone != other.tone || one.tag || other.tag) continue;
      const double roundness = roundness_weight * std::abs(one.roundness / other.roundness - 1);
      best = std::min(best, signature_error(one.signatures.front(), other.signatures.front()) + roundness);
    }
  }
  return best;
}

double Likeness::confidence() const {
  const double ahead_of_second = std::exp(-(second_error - error) / error_scale);
  const double ahead_of_unlike = std::exp(-(recognition_threshold - error) / error_scale);
  const double ahead_of_unlearned = std::exp(-(1 - doubt) / doubt_scale);
  return 1 / (1 + ahead_of_second + ahead_of_unlike + ahead_of_unlearned);
}

Likeness likeness(const SeenMark& mark, const LearnedObjects& objects, const LearnedObject& object) {
  Likeness out{.error = recognition_error(mark, object), .doubt = outline_doubt(mark, object)};
  for (const LearnedObject& rival : objects.all()) {
    if (&rival == &object) continue;
    const double error = recognition_error(mark, rival);
    if (error >= out.second_error) continue;
    out.second = &rival;
    out.second_error = error;
  }
  return out;
}

std::optional<Likeness> recognise(const SeenMark& mark, const LearnedObjects& objects, const LearnedObject& object) {
  const double error = recognition_error(mark, object);
  if (error > recognition_threshold) return std::nullopt;
  const double doubt = outline_doubt(mark, object);
  if (doubt > 1) return std::nullopt;
  // The square root of the error is a distance: within half of that to the nearest rival nothing else can be nearer.
  if (4 * error < object.rival_error) {
    const double least_distance = std::sqrt(object.rival_error) - std::sqrt(error);
    return Likeness{.error = error, .doubt = doubt, .second_error = least_distance * least_distance};
  }
  const Likeness out = likeness(mark, objects, object);
  if (out.margin() < least_margin) return std::nullopt;
  return out;
}

bool is_recognised(const SeenMark& mark, const LearnedObjects& objects, const LearnedObject& object) {
  return recognise(mark, objects, object).has_value();
}

const SeenMark* find_object(const std::vector<SeenMark>& marks, const LearnedObjects& objects,
                            const LearnedObject& object) {
  struct Candidate {
    const SeenMark* mark;
    double error;
  };
  std::vector<Candidate> recognised;
  for (const SeenMark& mark : marks) {
    const std::optional<Likeness> likely = recognise(mark, objects, object);
    if (likely) recognised.push_back({&mark, likely->error});
  }
  if (recognised.empty()) return nullptr;
  const Candidate likest = *std::ranges::min_element(recognised, {}, &Candidate::error);
  const double reach_px = neighbour_heights * likest.mark->height_px;
  const SeenMark* best = likest.mark;
  for (const Candidate& other : recognised) {
    const bool near = cv::norm(other.mark->centre - likest.mark->centre) < reach_px;
    const bool as_like = other.error - likest.error < least_margin;
    if (near && as_like && other.mark->area_px > best->area_px) best = other.mark;
  }
  return best;
}

std::vector<cv::Point2d> others_like(const std::vector<SeenMark>& marks, const LearnedObjects& objects,
                                     const LearnedObject& object, const SeenMark& found) {
  std::vector<cv::Point2d> out;
  for (const SeenMark& mark : marks) {
    if (!found.box.contains(mark.centre) && is_recognised(mark, objects, object)) out.push_back(mark.centre);
  }
  return out;
}

bool are_partners(const SeenMark& left, const SeenMark& right) {
  const double scale = right.height_px / left.height_px;
  const double area = right.area_px / left.area_px;
  return left.tone == right.tone && std::abs(left.centre.y - right.centre.y) < 1.0 &&
         left.centre.x > right.centre.x + 1 && scale > 0.9 && scale < 1.1 && area > 0.75 && area < 1.33 &&
         signature_error(left.signature, right.signature, 1) < recognition_threshold;
}

const SeenMark* find_partner(const SeenMark& left, const std::vector<SeenMark>& right,
                             std::optional<double> disparity_px) {
  const SeenMark* best = nullptr;
  double least = impossible;
  for (const SeenMark& mark : right) {
    if (!are_partners(left, mark)) continue;
    const double disparity = left.centre.x - mark.centre.x;
    const double error =
        disparity_px ? std::abs(disparity - *disparity_px) : signature_error(left.signature, mark.signature);
    if (error < least) {
      least = error;
      best = &mark;
    }
  }
  return best;
}

}  // namespace pizarra
