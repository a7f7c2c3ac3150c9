#include "agents/vision/objects/mark_choice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pizarra::vision {
namespace {

// Of the squared cosines of two faces of one cube, with what their measuring adds.
constexpr double most_facing = 1.2;
// How much print_contrast() differs between two prints of one ink on one ground: a standard deviation; and how often a
// lamp's reflection makes one as faint as may be. Measured of 5,100 photographed marks: nine in ten lay within 0.25 of
// the others, but for those in a reflection.
constexpr double print_spread = 0.25;
constexpr double reflected_share = 0.02;

// How likely a fainter print is the same one, 1 where it is no fainter.
double share_by_print(const SeenMark& mark, const SeenMark& found) {
  const double fainter = std::max(0.0, print_contrast(found) - print_contrast(mark)) / print_spread;
  return std::lerp(std::exp(-fainter * fainter / 2), 1.0, reflected_share);
}

}  // namespace

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
    if (likely) out += share_by_print(mark, found) * std::exp(-std::max(0.0, likely->error - error) / error_scale);
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

std::vector<const SeenMark*> find_partners(const SeenMark& left, const std::vector<SeenMark>& right) {
  std::vector<const SeenMark*> partners;
  for (const SeenMark& mark : right) {
    if (are_partners(left, mark)) partners.push_back(&mark);
  }
  std::ranges::sort(partners, {},
                    [&](const SeenMark* mark) { return signature_error(left.signature, mark->signature); });
  return partners;
}

const SeenMark* find_partner(const SeenMark& left, const std::vector<SeenMark>& right,
                             std::optional<double> disparity_px) {
  const std::vector<const SeenMark*> partners = find_partners(left, right);
  if (partners.empty()) return nullptr;
  if (!disparity_px) return partners.front();
  return *std::ranges::min_element(
      partners, {}, [&](const SeenMark* mark) { return std::abs(left.centre.x - mark->centre.x - *disparity_px); });
}

}  // namespace pizarra::vision
