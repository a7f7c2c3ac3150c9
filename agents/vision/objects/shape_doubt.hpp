#pragma once

// Whether a mark that matches a learned object may be something unlearned. Its picture, its outline and the grey of its
// middle are compared with the sample's. The difference is told as a part of what the image's noise, blur and a turned
// face may make of a mark of its size.
//
//   if (shape_doubt(mark, match_of(mark, object)).doubt > 1) ...       // it is something else

#include "agents/vision/objects/mark_match.hpp"

namespace pizarra::vision {

// The two doubts of a Likeness; infinite where nothing matches.
struct ShapeDoubt {
  double doubt = std::numeric_limits<double>::infinity();
  double unlearned = std::numeric_limits<double>::infinity();
};

ShapeDoubt shape_doubt(const SeenMark& mark, const MarkMatch& match);

}  // namespace pizarra::vision
