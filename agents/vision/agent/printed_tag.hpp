#pragma once

// An object that is known by the tag that it wears, without having been shown: it is learned from the tag's print.
//
//   const Result<LearnedSample> sample = learn_print({"lid", {"apriltag-36h11", 17}, 48}, objects);

#include "agents/vision/objects/learned.hpp"

namespace pizarra::vision {

struct TaggedObject {
  std::string name;
  Tag tag;
  double side_mm = 0;  // of its dark square
};

// As if a camera had looked at it squarely. Failures: those of learning, such as `ambiguous`, where the tag is known
// under another name.
Result<LearnedSample> learn_print(const TaggedObject& object, const LearnedObjects& objects);

}  // namespace pizarra::vision
