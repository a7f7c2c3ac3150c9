#pragma once

// The ground beyond each side of a mark. Beside an edge of its own that is its paper or a cube's face. Beside an edge
// that something in front of it makes it is that thing, most often of another grey. So where the ground beyond one side
// is another than beyond the others, a part of the mark may be hidden there, however whole it looks.
//
//   const double doubt = ground_doubt(grey, noise, mark);
//   const double confidence = confidence_if_off(of_whole, doubt, 1);
//
// A cover as bright as the ground passes for it. The edge of a shadow or of the card, or another thing, does not, where
// it comes as near as two pixels.

#include "agents/vision/marks/mark_measure.hpp"

namespace pizarra::vision {

// By how much the ground beyond one side differs from that beyond the others, as a part of what noise, print and the
// light's slope may make of it: from 1 on it is another. `noise` is that of the whole image, in which the mark is.
double ground_doubt(const cv::Mat1b& grey, double noise, const SeenMark& mark);

}  // namespace pizarra::vision
