#pragma once

// Tags as a person writes them: FAMILY:ID, or many of one family, FAMILY:0-11,20. A family goes by its whole name or by
// what stands behind apriltag- or aruco-.
//
//   Result<Tag> tag = tag_from_text("36h11:17");                   // that of tag_called("apriltag-36h11-17")
//   Result<std::vector<Tag>> tags = tags_from_text("36h11:0-11,20");
//
// Failures: bad-tag, unknown-family, and no-such-tag, of a number that the family does not have.

#include <string_view>
#include <vector>

#include "agents/vision/marks/tag.hpp"
#include "agents/vision/marks/tag_detection.hpp"
#include "lisp/result.hpp"

namespace pizarra::vision {

// Failure unknown-family, with all that there are.
Result<const TagFamily*> family_from_text(std::string_view text);
Result<Tag> tag_from_text(std::string_view text);
// As they are written, each once.
Result<std::vector<Tag>> tags_from_text(std::string_view text);

}  // namespace pizarra::vision
