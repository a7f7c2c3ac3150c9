#pragma once

// Takes the light's differences out of the picture of a tag whose print is known: the slope of a lamp's light, the
// edge of a shadow.
//
//   const cv::Mat1b even = evenly_lit(seen, print_of(family, 17));
//
// Dark and light cells that lie side by side have the same light. So they say how dark the print is, and with that each
// cell says how much light falls on it.

#include <opencv2/core.hpp>

namespace pizarra::vision {

// `seen`: the tag as a square, so many whole pixels a cell of the print, as print_of() has it.
cv::Mat1b evenly_lit(const cv::Mat1b& seen, const cv::Mat1b& print);

}  // namespace pizarra::vision
