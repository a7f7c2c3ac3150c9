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
// By less than this, blurred, an outline may differ that nobody learned: an octagon's from a circle. However much noise
// may make, what differs by more is not known for certain; and by one wave alone less of it counts as much as by all.
constexpr double least_other = 0.0015;
constexpr double wave_share = 0.5;
// A learned mark of which blur leaves so much in the middle is solid there. A ring whose hole blur fills is a disc but for
// this: its middle is lighter than its rim by more than uneven print, and noise, make of a solid one.
constexpr double solid_middle = 0.9;
constexpr double middle_slack = 0.1;
constexpr double middle_noise = 0.6;
// A mark slimmer than this by itself does not say from where it is seen.
constexpr double least_round = 0.9;
// Of the squared cosines of two faces of one cube, with what their measuring adds.
constexpr double most_facing = 1.2;

double weight_of_roundness(const LearnedObject& object) {
  return roundness_weight * ordinary_spread / std::max(ordinary_spread, object.roundness_spread);
}

double roundness_error(const SeenMark& mark, const LearnedSample& sample, double weight) {
  return weight * std::abs(mark.roundness / sample.roundness - 1);
}

double roundness_error(const SeenMark& mark, const LearnedObject& object) {
  const double weight = weight_of_roundness(object);
  double least = impossible;
  for (const LearnedSample& sample : object.samples) least = std::min(least, roundness_error(mark, sample, weight));
  return least;
}

// How near a mark comes to what was learned: all told, by its shape alone, as which of the blurs, and how turned.
struct Match {
  double error = impossible;
  double shape_error = impossible;
  std::size_t blur = 0;
  int turn = 0;
  const LearnedSample* sample = nullptr;
};

// Near the last turn first: where that hardly fits, the mark turned faster or is another.
SignatureFit sharp_fit(const SeenMark& mark, const LearnedSample& sample, std::optional<int> last_turn) {
  const TurnedSignatures& learned = sample.signatures.front();
  if (last_turn) {
    const SignatureFit near = fit_signature(mark.signature, learned, *last_turn);
    if (near.error < recognition_threshold / 2) return near;
  }
  return fit_signature(mark.signature, learned);
}

bool has_size(const SeenMark& mark, const LearnedSample& sample) {
  const double scale = mark.height_px / sample.height_px;
  return scale >= least_scale && scale <= most_scale;
}

// Of shapes, whatever their size.
Match shape_match(const SeenMark& mark, const LearnedSample& sample, double weight,
                  std::optional<int> last_turn = {}) {
  if (mark.tone != sample.tone || mark.slimness < least_slimness * sample.slimness) return {};
  // The parameters first: where they differ too much the shapes need not be compared.
  const double roundness = roundness_error(mark, sample, weight);
  if (roundness > recognition_threshold) return {};
  const SignatureFit sharp = sharp_fit(mark, sample, last_turn);
  Match best{sharp.error + roundness, sharp.error, 0, sharp.turn, &sample};
  for (std::size_t i = 1; i < sample.blurs.size() && best.shape_error > clear_error; ++i) {
    if (sample.blurs[i] * mark.height_px > widest_blur_px) break;
    // Blur turns nothing.
    const double error = signature_error(mark.signature, sample.signatures[i], sharp.turn);
    if (error < best.shape_error) best = {error + roundness, error, i, sharp.turn, &sample};
  }
  return best;
}

Match match_of(const SeenMark& mark, const LearnedSample& sample, double weight, std::optional<int> last_turn) {
  if (mark.tag || sample.tag) return mark.tag == sample.tag ? Match{.error = 0, .shape_error = 0} : Match();
  return has_size(mark, sample) ? shape_match(mark, sample, weight, last_turn) : Match();
}

Match match_of(const SeenMark& mark, const LearnedObject& object, std::optional<int> last_turn = {}) {
  const double weight = weight_of_roundness(object);
  Match best;
  for (const LearnedSample& sample : object.samples) {
    const Match match = match_of(mark, sample, weight, last_turn);
    if (match.error < best.error) best = match;
  }
  return best;
}

// As Likeness has them.
struct ShapeDoubt {
  double doubt = impossible;
  double unlearned = impossible;
};

// By how much the mark's middle is lighter than that of the sample, as a part of what a solid one's may be.
double middle_doubt(const SeenMark& mark, const LearnedSample& sample, double noise) {
  const float learned = sample.signatures.back().unturned().middle;
  if (learned < solid_middle) return 0;
  return std::max(0.0, (learned - mark.signature.middle) / (middle_slack + middle_noise * noise));
}

ShapeDoubt shape_doubt(const SeenMark& mark, const Match& match) {
  if (mark.tag) return {mark.tag_doubt, mark.tag_doubt};
  if (match.sample == nullptr) return {};
  const double contrast = std::max(1.0, std::abs(mark.mark_level - mark.ground_level));
  const double level_noise = std::max(least_noise, mark.noise / contrast);
  const double noise = level_noise / mark.height_px;
  const auto part = static_cast<std::size_t>(match.turn % TurnedSignatures::parts);
  const MarkOutline& learned = match.sample->outlines[part];
  const double ever = outline_share * learned.power();
  const double by_noise = outline_slack + outline_noise * noise * noise;
  const OutlineDifference difference = outline_difference(outline_of(mark.signature), learned);
  const double doubt =
      std::max(difference.in_all / (ever + by_noise), middle_doubt(mark, *match.sample, level_noise));
  return {doubt, std::max(doubt, difference.in_one / (ever + wave_share * std::min(by_noise, least_other)))};
}

// The square root of an error is a distance: who is as far from the object as the second and the mark together, and
// whoever comes after it, is no nearer to the mark than the second.
void find_second(const SeenMark& mark, const Match& match, const LearnedObjects& objects, const LearnedObject& object,
                 Likeness& out) {
  for (const LearnedObject::Rival& rival : object.rivals[match.blur]) {
    const double distance = std::max(0.0, std::sqrt(rival.error) - std::sqrt(match.shape_error));
    if (distance * distance >= out.second_error) return;
    const LearnedObject& other = objects.all()[rival.index];
    if (distance * distance + roundness_error(mark, other) >= out.second_error) continue;
    const double error = recognition_error(mark, other);
    if (error >= out.second_error) continue;
    out.second = &other;
    out.second_error = error;
  }
}

}  // namespace

double recognition_error(const SeenMark& mark, const LearnedObject& object) { return match_of(mark, object).error; }

std::optional<double> scale_of_another_size(const SeenMark& mark, const LearnedObject& object) {
  const double weight = weight_of_roundness(object);
  Match best{.error = recognition_threshold};
  for (const LearnedSample& sample : object.samples) {
    if (mark.tag || sample.tag || has_size(mark, sample)) continue;
    const Match match = shape_match(mark, sample, weight);
    if (match.error <= best.error) best = match;
  }
  if (best.sample == nullptr || shape_doubt(mark, best).doubt > 1) return std::nullopt;
  return mark.height_px / best.sample->height_px;
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

bool Likeness::is_ambiguous() const { return second != nullptr && margin() < least_margin; }

double Likeness::confidence() const {
  const double ahead_of_second = second == nullptr ? 0 : std::exp(-margin() / error_scale);
  const double ahead_of_unlike = std::exp(-(recognition_threshold - error) / error_scale);
  const double ahead_of_unlearned = std::exp(-(1 - unlearned) / doubt_scale);
  return 1 / (1 + ahead_of_second + ahead_of_unlike + ahead_of_unlearned + twins);
}

Likeness likeness(const SeenMark& mark, const LearnedObjects& objects, const LearnedObject& object) {
  const Match match = match_of(mark, object);
  const ShapeDoubt shape = shape_doubt(mark, match);
  Likeness out{.error = match.error, .doubt = shape.doubt, .unlearned = shape.unlearned, .turn = match.turn};
  find_second(mark, match, objects, object, out);
  return out;
}

std::optional<Likeness> recognise(const SeenMark& mark, const LearnedObjects& objects, const LearnedObject& object,
                                  std::optional<int> last_turn) {
  const Match match = match_of(mark, object, last_turn);
  Likeness out{.error = match.error, .turn = match.turn};
  if (out.error > recognition_threshold) return std::nullopt;
  const ShapeDoubt shape = shape_doubt(mark, match);
  out.doubt = shape.doubt;
  out.unlearned = shape.unlearned;
  if (out.doubt > 1) return std::nullopt;
  find_second(mark, match, objects, object, out);
  if (out.is_ambiguous()) return std::nullopt;
  return out;
}

bool is_recognised(const SeenMark& mark, const LearnedObjects& objects, const LearnedObject& object) {
  return recognise(mark, objects, object).has_value();
}

bool may_be_one_cube(const SeenMark& a, const SeenMark& b, double front_slimness) {
  if (cv::norm(a.centre - b.centre) >= neighbour_heights * std::max(a.height_px, b.height_px)) return false;
  if (front_slimness < least_round) return true;
  const auto facing = [&](const SeenMark& mark) { return std::min(1.0, mark.slimness / front_slimness); };
  return facing(a) * facing(a) + facing(b) * facing(b) < most_facing;
}

double front_slimness(const LearnedObject& object) {
  double least = 1;
  for (const LearnedSample& sample : object.samples) {
    if (!sample.tag) least = std::min(least, sample.slimness);
  }
  return least;
}

const SeenMark* find_object(const std::vector<SeenMark>& marks, const LearnedObjects& objects,
                            const LearnedObject& object, std::optional<cv::Point2d> seen_last) {
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
  std::erase_if(recognised, [&](const Candidate& other) { return other.error - likest.error >= least_margin; });
  if (seen_last) {
    const auto away = [&](const Candidate& candidate) { return cv::norm(candidate.mark->centre - *seen_last); };
    return std::ranges::min_element(recognised, {}, away)->mark;
  }
  const double reach_px = neighbour_heights * likest.mark->height_px;
  const SeenMark* best = likest.mark;
  for (const Candidate& other : recognised) {
    const bool near = cv::norm(other.mark->centre - likest.mark->centre) < reach_px;
    if (near && other.mark->area_px > best->area_px) best = other.mark;
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

double twins_of(const std::vector<SeenMark>& marks, const LearnedObjects& objects, const LearnedObject& object,
                const SeenMark& found) {
  const double error = recognition_error(found, object);
  const double front = front_slimness(object);
  double out = 0;
  for (const SeenMark& mark : marks) {
    if (found.box.contains(mark.centre) || may_be_one_cube(found, mark, front)) continue;
    const std::optional<Likeness> likely = recognise(mark, objects, object);
    if (likely) out += std::exp(-std::max(0.0, likely->error - error) / error_scale);
  }
  return out;
}

bool are_partners(const SeenMark& left, const SeenMark& right) {
  const double scale = right.height_px / left.height_px;
  const double area = right.area_px / left.area_px;
  return left.tone == right.tone && std::abs(left.centre.y - right.centre.y) < 1.0 &&
         left.centre.x > right.centre.x + 1 && scale > 0.9 && scale < 1.1 && area > 0.75 && area < 1.33 &&
         signature_error(left.signature, right.signature) < recognition_threshold;
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
