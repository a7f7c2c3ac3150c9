#pragma once

// Which learned object a seen mark is, and where in an image an object is: the second and third stage of the thesis'
// find (the first, candidates over the image, is ImageSegmentation).
//
//   double error = recognition_error(mark, *objects.find("circle"));     // infinite where it cannot be
//   const SeenMark* found = find_object(segmentation.marks(), objects, "circle");

#include "agents/vision/learned.hpp"

namespace pizarra {

// Above this error a mark is not the object.
inline constexpr double recognition_threshold = 0.085;

// The weighted difference of the parameters to the nearest sample. Infinite where tone, size (0.5 to 1.8 times as
// learned) or slimness (a face yawed by more than 45 degrees) cannot be the object's.
double recognition_error(const SeenMark& mark, const LearnedObject& object);

// How much two learned objects differ: the least over pairs of their samples, as a mark of one would differ from the
// other. Below `alike_below` noise, blur or a turned face may make one pass for the other.
double likeness_error(const LearnedObject& a, const LearnedObject& b);
inline constexpr double alike_below = 0.075;

// Whether the mark is this object rather than nothing or any other learned one.
bool is_recognised(const SeenMark& mark, const LearnedObjects& objects, const LearnedObject& object);

// The mark that is the object: the least error, but of several within one cube's width the largest. Null: none.
const SeenMark* find_object(const std::vector<SeenMark>& marks, const LearnedObjects& objects,
                            const LearnedObject& object);

// The partner of a left mark in the right image: same tone, line, size and shape, to the left of it and nearest to the
// expected disparity where one is given. Null: none.
const SeenMark* find_partner(const SeenMark& left, const std::vector<SeenMark>& right,
                             std::optional<double> disparity_px);

// Whether the two can be views of one mark.
bool are_partners(const SeenMark& left, const SeenMark& right);

}  // namespace pizarra
