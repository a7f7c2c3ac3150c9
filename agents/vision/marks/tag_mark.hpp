#pragma once

// A square in which a tag was read, as a mark: whether it is one at all, and where.
//
//   if (has_a_border(grey, corners, family) && tag_likeness(grey, corners, family, 17) > least_tag_likeness) ...
//   std::optional<SeenMark> mark = whole_tag(grey, corners, family, 17);

#include <optional>

#include "agents/vision/marks/mark_measure.hpp"
#include "agents/vision/marks/tag_detection.hpp"

namespace pizarra::vision {

// With less in common with its print a square is none. Of a tag whose cells are two pixels wide another family may read
// a tag of its own, 0.5 to 0.74 like that. A blurred one that can be found is 0.74 to 0.8 like its print. Where four
// cells may be mended hardly anything else spells a tag, and 0.6 is enough: motion by a cell leaves that.
double least_tag_likeness(const TagFamily& family);

// The mean of its four sides.
double side_px(const TagCorners& corners);

// Whether it is dark within the border and light around it, or of a wide family the other way round. Cells alone are no
// proof: of the larger families' codes a light triangle may spell one.
bool has_a_border(const cv::Mat1b& grey, const TagCorners& corners, const TagFamily& family);

// How like the tag's print that is what the image shows there, 1 at most.
double tag_likeness(const cv::Mat1b& grey, const TagCorners& corners, const TagFamily& family, int number);

// The tag, unless its corners are not its own but where something lies over its border.
std::optional<SeenMark> whole_tag(const cv::Mat1b& grey, const TagCorners& corners, const TagFamily& family,
                                  int number);

}  // namespace pizarra::vision
