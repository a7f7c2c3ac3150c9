#include "agents/vision/sight/wholeness.hpp"

#include <algorithm>
#include <cmath>

#include "agents/vision/marks/mark_ground.hpp"
#include "agents/vision/sight/covered_part.hpp"
#include "agents/vision/sight/first_look.hpp"
#include "agents/vision/sight/follow_mark.hpp"

namespace pizarra::vision {
namespace {

// One camera alone cannot tell some looks apart: a tilt and a straight edge over a part may look alike, and a triangle
// that looks small is farther away or covered. These are the numbers of tilted, and of farther, marks for each covered
// one. Where nothing uneven lies beside the mark, a cover must be as light as its ground, and lie along just such a
// line.
struct Odds {
  double tilted_for_one_covered;
  double farther_for_one_covered;
};
constexpr Odds on_even_ground{20, 12};
constexpr Odds on_uneven_ground{0.002, 0.05};
// Uneven ground beside a complete outline is a shadow's edge about as often as a cover over a part: never sure.
constexpr double shadow_share = 0.5;
// An outline whose edges are elsewhere is hardly the mark's.
constexpr double if_not_its_outline = 0.45;
// Another object may look like this one but for how slim it is. So a look is not sure where the ratio of its slimness
// to the learned one, or of the learned one to its own, is less than this.
constexpr double least_of_slimness = 0.72;
constexpr double if_squeezed = 0.87;
// A slim mark's outline counts against its moments where it leaves the centre open by this many times what may be told.
// Noise alone leaves the centre of a small mark open by less.
constexpr double clearly_off = 2;
// How many windows, tiles and the like, which a camera shows from any side, look just like the mark for each mark that
// is as faint and faces the camera.
constexpr double faint_others_for_one_mark = 0.02;

// A mark that is seen in part may be a part of something unlearned.
constexpr double if_part = 0.5;

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

// `of_learned_slimness`: the slimness seen over the learned one. A tilt may make a slim mark look rounder.
double most_by_plane(const PlaneView& plane, double of_learned_slimness) {
  if (!plane.agrees) return if_not_its_outline;
  const bool tilt_shows = plane.pose && plane.pose->shows_perspective();
  const double kept = std::min(of_learned_slimness, 1 / of_learned_slimness);
  return kept < least_of_slimness && !tilt_shows ? if_squeezed : 1;
}

// A mark is seldom turned far from the axis of a camera that is aimed at it; other things are as often as not.
double confidence_in_print(double confidence, const LearnedObject& object, const SeenPair& pair) {
  if (!pair.plane || !pair.plane->pose || !is_faint(pair.left, object)) return confidence;
  return 1 / (1 / confidence + faint_others_for_one_mark / usual_turn(*pair.plane->pose));
}

// In an object that nothing covers.
double confidence_in_object(const LearnedObject& object, const SeenPair& pair) {
  const double by_likeness = pair.likeness.confidence();
  if (pair.left.tag || pair.right || !pair.plane || pair.plane->known_bend_px) return by_likeness;
  const double most = most_by_plane(*pair.plane, pair.left.slimness / front_slimness(object));
  return confidence_in_print(std::min(by_likeness, most), object, pair);
}

// By one camera: a look that is slimmer than the mark is one of all of it, tilted, or of a part of it; perspective says
// how likely either is. Of what no edges registered nobody knows.
double confidence_before_one(const LearnedObject& object, const SeenPair& pair, double most_off_px, const Odds& odds) {
  const double slimness = front_slimness(object);
  const PlaneView* plane = pair.plane ? &*pair.plane : nullptr;
  const double of_whole = confidence_in_object(object, pair);
  const bool agrees = plane != nullptr && plane->agrees;
  const double now_bent_px = agrees ? off_if_bent_px(plane->sample->plane, plane->fit) : 0;
  const double known_px = plane != nullptr ? plane->known_bend_px.value_or(0) : 0;
  const double bent_px = std::sqrt(std::max(0.0, now_bent_px * now_bent_px - known_px * known_px));
  const auto if_off = [&](double off_px) {
    return confidence_if_off(of_whole, std::max(bent_px, off_px), most_off_px);
  };
  double covered = 1;
  double covered_of_smaller = 1;
  if (plane != nullptr && plane->pose) {
    covered = covered_rather_than_tilted(*plane->pose, odds.tilted_for_one_covered);
    covered_of_smaller = 1 / (1 + odds.farther_for_one_covered);
  }
  const double by_shape = std::lerp(if_off(0), if_off(may_be_off_by_shape_px(pair.left, slimness)), covered);
  const double by_size = std::lerp(if_off(0), if_off(may_be_off_by_size_px(object, pair.left)), covered_of_smaller);
  return std::min(by_shape, by_size);
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
  if (!pair.right) return confidence_before_one(object, pair, most_off_px(sight), on_even_ground);
  const double off_px = may_be_off_by_learned_px(object, face_size(sight.model(), object, pair), pair.left);
  return confidence_if_off(of_whole, off_px, most_off_px(sight));
}

// By its form, and by the ground beside it, which may hide a part.
double confidence_by_look(const StereoSight& sight, const LearnedObject& object, const SeenPair& pair) {
  const double by_form = confidence_by_form(sight, object, pair);
  const double doubt = ground_doubt(sight, pair);
  if (pair.right || pair.left.tag || !pair.plane) return confidence_if_off(by_form, doubt, 1);
  const double in_shadow = shadow_share * confidence_before_one(object, pair, most_off_px(sight), on_uneven_ground);
  if (!pair.plane->agrees) return std::max(confidence_if_off(by_form, doubt, 1), in_shadow);
  const OutlineGround& ground = pair.plane->ground;
  const double by_ground = confidence_if_off(by_form, std::min(doubt, ground.doubt), 1);
  return std::lerp(std::max(by_ground, in_shadow), by_form, ground.light);
}

double confidence_by_outline(double by_look, double of_whole, const SeenPair& pair, double most_off_px) {
  if (!pair.plane || !pair.plane->may_be_off_px) return by_look;
  const double off_px = *pair.plane->may_be_off_px;
  if (!pair.plane->sample->is_slim()) return std::max(by_look, confidence_if_off(of_whole, off_px, most_off_px));
  return pair.right ? std::min(by_look, confidence_if_off(of_whole, off_px / clearly_off, most_off_px)) : by_look;
}

double confidence_in_look(const StereoSight& sight, const LearnedObject& object, const SeenPair& pair) {
  if (pair.plane && pair.plane->is_part) {
    const double of_part = 1 / (1 / if_part + pair.likeness.other_form);
    return confidence_if_off(of_part, 2 * pair.plane->fit.middle_spread_px, most_off_px(sight));
  }
  const double by_look = confidence_by_look(sight, object, pair);
  return confidence_by_outline(by_look, confidence_in_object(object, pair), pair, most_off_px(sight));
}

Wholeness::Look Wholeness::look_at(const camera::StereoModel& model, const LearnedObject& object, const SeenPair& now,
                                   Time captured, double most_off_px, bool lost) const {
  // A tag that is seen is whole.
  if (now.left.tag) return {};
  Look out;
  if (now.right) out.face = face_size(model, object, now);
  const double by_learned_px = now.right ? may_be_off_by_learned_px(object, *out.face, now.left) : 0;
  out.may_be_off_px = by_learned_px;
  if (out.face && face_) out.may_be_off_px = std::max(out.may_be_off_px, face_->off_if_covered_px(*out.face, now.left));
  out.smaller = out.face && face_ && face_->is_more_than(*out.face, now.left);
  const bool as_large = out.face && face_ && !out.smaller && face_->is_as_large(*out.face, now.left, most_off_px);
  const auto is_it = [&](const std::optional<WholeMark>& whole, const SeenMark& mark) {
    if (!whole || as_large) return true;
    const WholeMark::Look look = whole->look_at(mark, captured, most_off_px, out.smaller);
    out.elsewhere = out.elsewhere || (look == WholeMark::Look::unlike && !lost);
    return look != WholeMark::Look::covered && !out.elsewhere;
  };
  out.whole = is_it(left_, now.left) && (!now.right || is_it(right_, *now.right));
  out.hardly_covered = !out.whole && out.smaller && out.may_be_off_px <= most_off_px;
  if (out.hardly_covered) out.whole = true;
  // In one of the images more is to be seen than is remembered, and all that was learned: what is remembered was
  // covered.
  const bool is_all = now.right && by_learned_px <= most_off_px;
  const bool is_more =
      (left_ && left_->is_less_than(now.left)) || (now.right && right_ && right_->is_less_than(*now.right));
  out.anew = !out.whole && is_all && is_more;
  if (out.anew) return {.whole = true, .anew = true, .may_be_off_px = by_learned_px, .face = out.face};
  return out;
}

void Wholeness::follow(const SeenPair& now, const Look& look, Time captured) {
  if (look.anew) {
    left_.reset();
    if (now.right) {
      right_.reset();
      face_.reset();
    }
  }
  // A part of what was lost or is covered, or a copy of another size: none is what it looks like while it is whole.
  if (now.left.tag || (!left_ && look.smaller) || look.hardly_covered) return;
  remember(left_, now.left, captured);
  if (now.right) {
    remember(right_, *now.right, captured);
    if (face_) face_->follow(*look.face, now.left);
    if (!face_) face_.emplace(*look.face, now.left);
    return;
  }
  if (right_) right_->wait(captured);
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
