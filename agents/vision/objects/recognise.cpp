#include "agents/vision/objects/recognise.hpp"

#include <algorithm>
#include <cmath>

#include "agents/vision/objects/shape_doubt.hpp"

namespace pizarra::vision {
namespace {

// The square root of an error is a distance: who is as far from the object as the second and the mark together, and
// whoever comes after it, is no nearer to the mark than the second.
void find_second(const SeenMark& mark, const MarkMatch& match, const LearnedObjects& objects,
                 const LearnedObject& object, Likeness& out) {
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
  const MarkMatch match = match_of_another_size(mark, object);
  if (match.error > recognition_threshold || shape_doubt(mark, match).doubt > 1) return std::nullopt;
  return scale_of(mark, *match.sample);
}

bool Likeness::is_ambiguous() const { return second != nullptr && margin() < least_margin; }

double Likeness::confidence() const {
  const double ahead_of_second = second == nullptr ? 0 : std::exp(-margin() / error_scale);
  const double ahead_of_unlike = std::exp(-(recognition_threshold - error) / error_scale);
  const double ahead_of_unlearned = std::exp(-(1 - unlearned) / doubt_scale);
  return 1 / (1 + ahead_of_second + ahead_of_unlike + ahead_of_unlearned + other_form + twins);
}

double Likeness::confidence_if_covered() const {
  Likeness of_part = *this;
  of_part.other_form = 0;
  return of_part.confidence();
}

Likeness likeness(const SeenMark& mark, const LearnedObjects& objects, const LearnedObject& object) {
  const MarkMatch match = match_of(mark, object);
  const ShapeDoubt shape = shape_doubt(mark, match);
  Likeness out{.error = match.error, .doubt = shape.doubt, .unlearned = shape.unlearned, .turn = match.turn};
  find_second(mark, match, objects, object, out);
  return out;
}

std::optional<Likeness> recognise(const SeenMark& mark, const LearnedObjects& objects, const LearnedObject& object,
                                  std::optional<int> last_turn) {
  const MarkMatch match = match_of(mark, object, last_turn);
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

}  // namespace pizarra::vision
