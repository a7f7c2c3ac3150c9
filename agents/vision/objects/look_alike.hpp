#pragma once

// Learned objects that look so much alike that noise may make one pass for the other. Those that cannot be told apart
// at all are refused when they are learned (`ambiguous`).
//
//   for (const Datum& fact : look_alikes(objects)) transaction.tell(fact);

#include "agents/vision/objects/learned.hpp"

namespace pizarra::vision {

// Of each such pair (look-alike NAME OTHER ERROR "SENTENCE"), NAME learned later.
std::vector<Datum> look_alikes(const LearnedObjects& objects);

}  // namespace pizarra::vision
