#pragma once

// Every tag that an image shows, of the families that are asked for, whether anybody has pointed at it or not.
//
//   const std::vector<SeenMark> seen = all_tags(grey, families);       // seen[0].tag, seen[0].corners
//
// Nobody says here that a tag is there, so more is asked of a square than of one that was clicked on: light around it,
// and all of its cells like its print.

#include <span>
#include <vector>

#include "agents/vision/marks/mark_measure.hpp"
#include "agents/vision/marks/tag_detection.hpp"

namespace pizarra::vision {

inline constexpr std::size_t most_tags_at_once = 256;

// The largest first, no more than most_tags_at_once. A square that several families read is the tag that it is likest.
std::vector<SeenMark> all_tags(const cv::Mat1b& grey, std::span<const TagFamily* const> families);

}  // namespace pizarra::vision
