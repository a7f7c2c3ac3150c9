#pragma once

// Whether a disturbance is as hard for our open loop as it was for a published one. Both carry out their first plan
// blindly, so how often they succeed says how hard they were disturbed.
//
//   hardness(27.5, 21.7);      // "equal"

namespace pizarra::bench {

// Of the percentages that were reached: `equal` within ten points, else `easier` or `harder` for ours.
const char* hardness(double ours_percent, double published_percent);

}  // namespace pizarra::bench
