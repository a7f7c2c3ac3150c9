#include "agents/vision/sight/wholeness.hpp"

#include <algorithm>

#include "agents/vision/marks/mark_ground.hpp"
#include "agents/vision/sight/covered_part.hpp"
#include "agents/vision/sight/first_look.hpp"
#include "agents/vision/sight/follow_mark.hpp"

namespace pizarra::vision {
namespace {

// One camera does not know a face that is turned, or a triangle farther away than it was learned, from one that
// something covers: where a look says no more than that, it is told at so much at least.
constexpr double least_if_turned = 0.1;

void remember(std::optional<WholeMark>& whole, const SeenMark& now, Time captured) {
  if (whole) {
    whole->follow(now, captured);
  } else {
    whole.emplace(now, captured);
  }
}

FaceSize face_size(const camera::StereoModel& model, const LearnedObject& object, const SeenPair& pair) {
  return face_size(model, pair.left, *pair.right, front_slimness(object));
}

}  // namespace

double most_off_px(const StereoSight& sight) { return px_in(sight.left(), 1); }

double ground_doubt(const StereoSight& sight, const SeenPair& pair) {
  // Its cells say it, in a shadow too.
  if (pair.left.tag) return 0;
  const double left = ground_doubt(sight.left(), sight.noise(), pair.left);
  return pair.right ? std::max(left, ground_doubt(sight.right(), sight.noise(), *pair.right)) : left;
}

double confidence_by_form(const StereoSight& sight, const LearnedObject& object, const SeenPair& pair) {
  const double of_whole = pair.likeness.confidence();
  if (pair.left.tag) return of_whole;
  const double off_px = pair.right ? may_be_off_by_learned_px(object, face_size(sight.model(), object, pair), pair.left)
                                   : may_be_off_by_learned_px(object, pair.left);
  const double by_form = confidence_if_off(of_whole, off_px, most_off_px(sight));
  return pair.right ? by_form : std::max(by_form, least_if_turned * of_whole);
}

double confidence_at_first(const StereoSight& sight, const LearnedObject& object, const SeenPair& pair) {
  return confidence_if_off(confidence_by_form(sight, object, pair), ground_doubt(sight, pair), 1);
}

Wholeness::Look Wholeness::look_at(const camera::StereoModel& model, const LearnedObject& object, const SeenPair& now,
                                   Time captured, double most_off_px, bool lost) const {
  // A tag that is seen is whole.
  if (now.left.tag) return {};
  Look out;
  if (now.right) out.face = face_size(model, object, now);
  if (now.right) out.may_be_off_px = may_be_off_by_learned_px(object, *out.face, now.left);
  if (!now.right) {
    // What the pair has just seen is no farther away than it was.
    const bool size_known = left_ && face_;
    const double by_learned = size_known ? may_be_off_by_shape_px(now.left, front_slimness(object))
                                         : may_be_off_by_learned_px(object, now.left);
    out.may_be_off_px = std::max(widest_.off_if_covered_px(now.left), by_learned);
  }
  if (out.face && face_) out.may_be_off_px = std::max(out.may_be_off_px, face_->off_if_covered_px(*out.face, now.left));
  out.smaller = out.face && face_ && face_->is_more_than(*out.face, now.left);
  const bool as_large = out.face && face_ && !out.smaller && face_->is_as_large(*out.face, now.left, most_off_px);
  const auto is_it = [&](const std::optional<WholeMark>& whole, const SeenMark& mark) {
    if (!whole || as_large) return true;
    const WholeMark::Look look = whole->look_at(mark, captured, most_off_px, out.smaller);
    return look != WholeMark::Look::covered && (look != WholeMark::Look::unlike || lost);
  };
  out.whole = is_it(left_, now.left) && (!now.right || is_it(right_, *now.right));
  return out;
}

void Wholeness::follow(const SeenPair& now, const Look& look, Time captured) {
  // A part of what was lost, or a copy of another size: neither is what it looks like while it is whole.
  if (now.left.tag || (!left_ && look.smaller)) return;
  remember(left_, now.left, captured);
  if (now.right) {
    remember(right_, *now.right, captured);
    widest_ = {};
    if (face_) face_->follow(*look.face, now.left);
    if (!face_) face_.emplace(*look.face, now.left);
    return;
  }
  if (right_) right_->wait(captured);
  widest_.follow(now.left);
}

void Wholeness::wait(Time captured) {
  for (std::optional<WholeMark>* whole : {&left_, &right_}) {
    if (*whole) (*whole)->wait(captured);
  }
}

void Wholeness::lose() {
  const bool rests = left_ && !left_->moves();
  if (rests) return;
  left_.reset();
  right_.reset();
}

}  // namespace pizarra::vision
