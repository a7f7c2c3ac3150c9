#pragma once

// The tags that OpenCV does not know: AprilTag's Standard41h12, Circle21h7 and Standard52h13, as libapriltag reads
// them. Their square is light within a dark line. Some of their cells are around that line, so that a tag of the same
// size on paper has more of them. The size of such a tag is the side of its light square, as in AprilTag's own
// programs.
//
//   const TagDetection seen = detect_wide_tags(grey, *family_called("apriltag-standard41h12"));
//
// libapriltag looks numbers up in a table with every code that it takes for a tag. The table of a family is made when
// the family is first looked for, and stays: 4.3 MB of Standard41h12 and 0.04 MB of Circle21h7, with one wrong cell
// mended; 2.3 MB of Standard52h13, with none (one would take 120 MB).

#include "agents/vision/marks/tag_detection.hpp"

namespace pizarra::vision {

// Only those that are like their print. May be called from several threads, which wait for each other.
TagDetection detect_wide_tags(const cv::Mat1b& grey, const TagFamily& family);

int wide_tags_of(const TagFamily& family);

// As print_of() has it. Around a circle's corners nothing is printed.
cv::Mat1b wide_print(const TagFamily& family, int number);

}  // namespace pizarra::vision
