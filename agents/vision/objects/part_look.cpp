#include "agents/vision/objects/part_look.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "agents/vision/marks/outline_guess.hpp"
#include "agents/vision/objects/mark_match.hpp"
#include "agents/vision/objects/plane_look.hpp"

namespace pizarra::vision {
namespace {

// Of the outline; the guess is not yet registered, and edges are missing at its corners.
constexpr double least_shown = 0.4;
constexpr int fits_by_border = 2;
constexpr double least_at_first = 0.3;
constexpr double least_supported = 0.42;
constexpr double most_contradicted = 0.04;
// Of the places that support it. A ring and a crescent are borders without so much inside.
constexpr double least_filled = 0.5;
// Shorter edges make shapes everywhere.
constexpr double least_supported_px = 50;
// Of the mark's standard deviation, and px.
constexpr double most_rms_share = 0.03;
constexpr double most_rms_px = 0.2;
// A part says too little of a face that is turned farther away.
constexpr double least_slimness = 0.75;
// A place that the part leaves more open is none.
constexpr double most_spread_px = 1.2;
// What is told has more: a turn makes up for what a part lacks, and where two sides alone show, the mark may be larger
// and lie farther along them.
constexpr double least_supported_px_told = 75;
constexpr double least_slimness_told = 0.85;
constexpr double most_spread_px_told = 0.35;
// A print's edges are where it says, those of other things only nearly: such a fit may leave more open.
constexpr double most_spread_px_if_exact = 0.75;
constexpr double exact_rms_px = 0.1;
// Ink on paper: no fainter than so much of what was learned, in its logarithm; edges of other things are mostly
// fainter.
constexpr double least_contrast_told = 0.85;
// Where the levels of either side are those of one print, edges
// are rarer still, so that fewer of them say as much.
constexpr double most_ratio_needed = 5;
constexpr double most_uneven_print = 0.035;
constexpr double least_supported_px_of_print = 55;
constexpr double most_spread_px_of_print = 1.2;
constexpr double exact_rms_px_of_print = 0.18;
// Three sides of the arm of a larger thing are most of a small square: its fourth is ink on both sides. What hides a
// part is seldom as dark all along.
constexpr double most_going_on = 0.15;
constexpr double smallest_px = 5;  // a standard deviation
// Another explanation of the same edges must be so much shorter.
constexpr double most_of_rival = 0.9;

SizeRange sizes_of(const LearnedSample& sample, double focal_px) {
  const double shown = sample.focal_px > 0 && focal_px > 0 ? focal_px / sample.focal_px : 1;
  const double as_learned = shown * sample.height_px;
  return {std::max(smallest_px, least_scale * as_learned), most_scale * as_learned};
}

double slimness_of(const PlaneFit& fit) {
  SeenMark mark;
  set_place(mark, fit, {});
  return mark.slimness;
}

bool may_be(const PartLook& look) {
  return look.part.supported >= least_supported && look.part.contradicted <= most_contradicted &&
         look.part.filled >= least_filled &&
         look.part.rms_px <= std::hypot(most_rms_px, most_rms_share * look.fit.size_px()) &&
         look.part.supported_px >= least_supported_px && look.fit.middle_spread_px <= most_spread_px &&
         slimness_of(look.fit) >= least_slimness;
}

bool is_even_print(const SeenPart& part) { return part.uneven <= most_uneven_print; }

double least_supported_px_of(const SeenPart& part) {
  const bool fewer_do = is_even_print(part) && part.goes_on <= most_going_on;
  return fewer_do ? least_supported_px_of_print : least_supported_px_told;
}

double most_spread_of(const SeenPart& part) {
  if (is_even_print(part) && part.rms_px <= exact_rms_px_of_print) return most_spread_px_of_print;
  return part.rms_px <= exact_rms_px ? most_spread_px_if_exact : most_spread_px_told;
}

double least_ratio_told(const LearnedSample& sample) {
  const double of_learned = sample.contrast > 0 ? std::exp(least_contrast_told * sample.contrast) : most_ratio_needed;
  return std::min(most_ratio_needed, of_learned);
}

bool may_be_told(const PartLook& look) {
  return look.part.ratio >= least_ratio_told(*look.sample) &&
         look.part.supported_px >= least_supported_px_of(look.part) &&
         look.fit.middle_spread_px <= most_spread_of(look.part) && slimness_of(look.fit) >= least_slimness_told;
}

// With whatever larger it may be a part of.
cv::Rect around(const PartLook& look) {
  constexpr double reach = 5;
  const double half = reach * look.fit.size_px();
  const cv::Point2d at = look.fit.in_image({0, 0});
  return {cvRound(at.x - half), cvRound(at.y - half), cvRound(2 * half), cvRound(2 * half)};
}

bool are_at_one_place(const PartLook& a, const PartLook& b) {
  const double apart = cv::norm(a.fit.in_image({0, 0}) - b.fit.in_image({0, 0}));
  return apart < 1.5 * std::max(a.fit.size_px(), b.fit.size_px());
}

// Of a mark that was turned away when it was learned, the template is stretched along one of two axes.
PlaneLens lens_for(const LearnedSample& sample, PlaneLens lens) {
  const double stretch = (1 - sample.slimness) / (1 + sample.slimness);
  lens.stretch_spread = std::max(lens.stretch_spread, std::numbers::sqrt2 * stretch);
  return lens;
}

// What hides a part has edges as well: the next fits go by the border alone that the one before showed.
std::optional<PartLook> part_look(const ImageCut& cut, const LearnedSample& sample, const cv::Matx33d& start,
                                  const PlaneLens& any_lens) {
  const PlaneLens lens = lens_for(sample, any_lens);
  std::optional<PlaneFit> fit = fit_plane(cut.pixels, sample.plane, start, sample.tone, for_part, lens);
  for (int again = 0; again < fits_by_border && fit; ++again) {
    if (judge_part(cut, sample.plane, *fit, sample.tone).supported < least_at_first) return std::nullopt;
    fit = fit_to_border(cut.pixels, sample.plane, *fit, sample.tone, for_part, lens);
  }
  if (!fit) return std::nullopt;
  const SeenPart part = judge_part(cut, sample.plane, *fit, sample.tone);
  return PartLook{&sample, std::move(*fit), part};
}

std::vector<PartLook> all_looks(const ImageCut& cut, const EdgeChains& edges, const LearnedObject& object,
                                const PlaneLens& lens) {
  std::vector<PartLook> out;
  for (const LearnedSample& sample : object.samples) {
    // Parts are registered without the stretch that a slim mark has.
    if (sample.tag || sample.is_slim()) continue;
    for (const OutlineGuess& guess :
         outline_guesses(edges, sample.plane, sample.tone, sizes_of(sample, lens.focal_px), least_shown)) {
      std::optional<PartLook> look = part_look(cut, sample, guess.to_image, lens);
      if (look && may_be(*look)) out.push_back(std::move(*look));
    }
  }
  std::ranges::sort(out, std::ranges::greater(), [](const PartLook& look) { return look.part.supported_px; });
  return out;
}

}  // namespace

std::vector<PartLook> look_for_parts(const ImageCut& cut, const EdgeChains& edges, const LearnedObjects& objects,
                                     const LearnedObject& object, const PlaneLens& lens) {
  std::vector<PartLook> out;
  for (PartLook& look : all_looks(cut, edges, object, lens)) {
    const auto is_there = [&](const PartLook& other) { return are_at_one_place(look, other); };
    if (std::ranges::none_of(out, is_there)) out.push_back(std::move(look));
  }
  std::erase_if(out, [&](const PartLook& look) {
    if (!may_be_told(look)) return true;
    const EdgeChains there = edges.within(around(look));
    return std::ranges::any_of(objects.all(), [&](const LearnedObject& other) {
      if (same_name(other.name, object.name)) return false;
      return std::ranges::any_of(all_looks(cut, there, other, lens), [&](const PartLook& rival) {
        return are_at_one_place(look, rival) && rival.part.supported_px > most_of_rival * look.part.supported_px;
      });
    });
  });
  return out;
}

SeenMark whole_mark(const ImageCut& cut, const PartLook& look) {
  SeenMark out;
  set_outline(out, look.fit, *look.sample);
  out.tone = look.sample->tone;
  out.mark_level = look.part.ink;
  out.ground_level = look.part.ground;
  out.flattened = true;
  out.roundness = look.sample->roundness;
  out.noise = cut.noise;
  out.signature = look.sample->signatures.front().unturned();
  return out;
}

}  // namespace pizarra::vision
