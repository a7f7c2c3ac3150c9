#pragma once

// Where a mark is and how it is turned, with standard deviations, for people and for programs.
//
//   place 12.31 -4.02 501.17 mm, off by 0.05 0.05 0.61; turned 1.20 -30.11 0.42 degrees, off by 0.90 0.70 0.20
//   "place":[12.31,-4.02,501.17],"place_spread":[...],"turn":[...],"turn_spread":[...]
//
// Where another tilt looks nearly alike: `; or, by 31 %, turned 1.15 28.40 0.40 degrees`, "flipped":{"turn":[...],
// "share":0.310}.

#include <string>

#include "agents/vision/sight/mark_pose.hpp"

namespace pizarra::programs {

std::string pose_words(const vision::MarkPose& pose);
// The members of an object.
std::string pose_json(const vision::MarkPose& pose);

}  // namespace pizarra::programs
