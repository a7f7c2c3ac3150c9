#include "agents/vision/sight/surest_look.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "agents/vision/marks/other_outline.hpp"
#include "agents/vision/sight/followed_plane.hpp"
#include "agents/vision/sight/whole_outline.hpp"
#include "agents/vision/sight/wholeness.hpp"

namespace pizarra::vision {
namespace {

// With less hardly anything speaks for it.
constexpr double least_confidence = 0.03;
// Of photographed prints that were so faint the learned ones, in a lamp's reflection, had more; other things had less.
constexpr double least_of_faint = 0.8;
// With more no other place is looked at; and by so much another one must be surer.
constexpr double clearly_sure = 0.35;
constexpr double clearly_surer = 0.3;
// Of two that are about as sure, the one whose edges contradict its pose by so much less is e^4 times as likely.
constexpr double clearly_likelier = 4;
// A faint square is more often a window of a house, so that a mark of twice its contrast is likelier.
const double clearly_bolder = std::log(2);
// The share of prints of one ink that are as faint.
constexpr double share_of_faint = 0.1;
// The ground beside a cover raises a greater doubt. In photographs with covered marks 64 of 66 wholes that were told
// where none was had one. Of 101 whole marks that were tilted and not sure, one in ten had.
constexpr double least_of_cover = 0.2;

// By how much another homography explains its edges better than any pose of it.
double contradiction(const SeenPair& pair) {
  const std::optional<PlanePose>* pose = pair.plane ? &pair.plane->pose : nullptr;
  return pose != nullptr && *pose ? std::max(0.0, (*pose)->misfit - (*pose)->free_misfit) : 0;
}

double contrast(const SeenPair& pair) { return print_contrast(pair.left); }

// A whole with uneven ground may be another thing that is covered; a faint one may be no print. The farther such a
// whole is turned away, the likelier is a part elsewhere.
bool gives_way(const StereoSight& sight, const SeenPair& whole, double of_whole, const SeenPair& part, double of_part) {
  const PlaneView* plane = whole.plane ? &*whole.plane : nullptr;
  if (plane == nullptr || plane->is_part || whole.left.box.contains(part.left.centre)) return false;
  const bool is_bolder = contrast(part) > contrast(whole) + clearly_bolder;
  const double by_outline = plane->agrees ? plane->ground.doubt : 1;
  if (!is_bolder && std::min(ground_doubt(sight, whole), by_outline) < least_of_cover) return false;
  const double turn = plane->pose ? usual_turn(*plane->pose) : 1;
  return of_part > of_whole * turn * (is_bolder ? share_of_faint : 1);
}

}  // namespace

void look_at_plane(StereoSight& sight, const LearnedObject& object, SeenPair& pair) {
  pair.plane = view_plane(sight.left_segmentation().cut(), object, pair.left);
  if (!pair.plane) return;
  const LearnedSample& sample = *pair.plane->sample;
  pair.likeness.other_form = odds_of_other_outline(sample.plane, pair.plane->fit);
  if (!pair.plane->agrees) return;
  std::optional<PlaneFit> right;
  if (pair.right) right = fit_in_right(sight, sample, pair, pair.plane->fit, to_follow);
  std::optional<PlanePose>& pose = pair.plane->pose;
  pose = pose_in_plane(sight.model(), sample, pair.plane->fit, right ? &*right : nullptr);
  if (pose) pair.likeness.other_form += pose->odds_of_no_plane();
  const double most_px = most_off_px(sight);
  if (pose) {
    const RegisteredOutline seen{sample, pair.plane->fit, right ? &*right : nullptr, *pose, pair.right.has_value()};
    pair.plane->may_be_off_px = off_by_outline_px(seen, most_px);
  }
  // In one of both images it is registered with something else, or in part.
  if (pose && pose->by_both && pose->is_contradicted()) pose.reset();
}

std::optional<std::string_view> why_none(const LearnedObject& object, const SeenPair& seen, double confidence) {
  if (confidence < least_confidence) {
    return "a mark is like it, but a part of it is hidden, or it is none: the ground around it, or its size, is "
           "another than a whole one's";
  }
  const bool is_shape = !seen.left.tag;
  if (is_shape && confidence < least_of_faint && is_faint(seen.left, object)) {
    return "a mark is like it, but its print is much fainter than it was learned";
  }
  return std::nullopt;
}

SurestLook::SurestLook(StereoSight& sight, const LearnedObjects& objects, const LearnedObject& object,
                       std::optional<SeenPair> likest, std::span<const cv::Point2d> others)
    : sight_(sight), objects_(objects), object_(object), others_(others), best_(std::move(likest)) {
  if (best_) confidence_ = confidence_in_look(sight_, object_, *best_);
}

bool SurestLook::is_clear() const {
  return best_ && confidence_ >= clearly_sure && contradiction(*best_) <= clearly_likelier &&
         !is_faint(best_->left, object_);
}

bool SurestLook::may_be_it(const SeenPair& seen) const {
  const auto is_there = [&](const cv::Point2d& other) { return seen.left.box.contains(other); };
  return sight_.holds(seen.left) && std::ranges::none_of(others_, is_there);
}

void SurestLook::take_surer(SeenPair&& other) {
  if (!may_be_it(other)) return;
  if (!other.plane) look_at_plane(sight_, object_, other);
  const double confidence = confidence_in_look(sight_, object_, other);
  const bool is_about_as_sure = best_ && confidence > confidence_ - clearly_surer;
  const bool is_likelier = is_about_as_sure && contradiction(other) + clearly_likelier < contradiction(*best_);
  const bool is_bolder = is_about_as_sure && contrast(other) > contrast(*best_) + clearly_bolder;
  const bool is_surer = best_ ? confidence >= confidence_ + clearly_surer : confidence >= least_confidence;
  if (!is_likelier && !is_bolder && !is_surer) return;
  confidence_ = confidence;
  best_ = std::move(other);
}

void SurestLook::look_for_whole() {
  const bool is_contradicted = best_ && contradiction(*best_) > clearly_likelier;
  if (best_ && !is_clear()) {
    for (const SeenMark& mark : sight_.left_segmentation().marks()) {
      const std::optional<Likeness> likely = recognise(mark, objects_, object_);
      if (likely && !best_->left.box.contains(mark.centre)) {
        take_surer({.left = mark, .right = std::nullopt, .likeness = *likely});
      }
    }
  }
  if (confidence_ >= clearly_sure && !is_contradicted) return;
  for (SeenPair& thorough : sight_.find_in_plane(objects_, object_)) take_surer(std::move(thorough));
}

void SurestLook::look_for_parts() {
  if (confidence_ >= surely && !is_faint(best_->left, object_)) return;
  for (SeenPair& part : sight_.find_parts(objects_, object_)) {
    if (!may_be_it(part)) continue;
    if (best_ && gives_way(sight_, *best_, confidence_, part, confidence_in_look(sight_, object_, part))) best_.reset();
    take_surer(std::move(part));
  }
}

}  // namespace pizarra::vision
