#pragma once

// How near a seen mark comes to a learned object: the weighted difference of their parameters, the picture first. A
// parameter counts the less the more the samples of an object differ in it.
//
//   const MarkMatch match = match_of(mark, *objects.find("circle"));
//   match.error;                                       // infinite where it cannot be

#include <limits>

#include "agents/vision/objects/learned.hpp"

namespace pizarra::vision {

// Above this error a mark is not the object.
inline constexpr double recognition_threshold = 0.085;

// How many times as large as it was learned an object is looked for.
inline constexpr double least_scale = 0.35;
inline constexpr double most_scale = 2.5;
// More than this no lens that is nearly focused blurs.
inline constexpr double widest_blur_px = 2.2;

// How many times as large it is as the camera that shows it would have shown it when it was learned: by its height,
// which a yaw does not change; or, of what is slim, by its area, which no turn in the image does. Where a focal length
// is not known, as the camera it was learned with showed it.
double scale_of(const SeenMark& mark, const LearnedSample& sample);
// The same by both principal standard deviations: what a turn makes it smaller by, and whatever covers a side of it.
double spread_scale_of(const SeenMark& mark, const LearnedSample& sample);

// To the nearest sample: all told, by its shape alone, as which of its blurs, and how turned.
struct MarkMatch {
  double error = std::numeric_limits<double>::infinity();
  double shape_error = std::numeric_limits<double>::infinity();
  std::size_t blur = 0;
  int turn = 0;  // of TurnedSignatures::turns
  const LearnedSample* sample = nullptr;
};

// Infinite where tone, size or slimness (a face yawed by more than 45 degrees) cannot be the object's. Sooner where
// `last_turn` tells about how the mark is turned.
MarkMatch match_of(const SeenMark& mark, const LearnedObject& object, std::optional<int> last_turn = {});
// But for its size: of samples that were of another size.
MarkMatch match_of_another_size(const SeenMark& mark, const LearnedObject& object);

// Whether its print is fainter than it was learned by more than noise, blur and a camera's black make it: in a lamp's
// reflection, or of another thing. False where it is not known how bold it was.
bool is_faint(const SeenMark& mark, const LearnedObject& object);

double roundness_error(const SeenMark& mark, const LearnedObject& object);

// How much two learned objects differ: the least over pairs of their samples, as a mark of one would differ from the
// other. Below `alike_below` noise, blur or a turned face may make one pass for the other.
double likeness_error(const LearnedObject& a, const LearnedObject& b);
inline constexpr double alike_below = 0.075;

}  // namespace pizarra::vision
