#pragma once

// The meaning of a tag: its family and its number.
//
//   tag_name({"apriltag-36h11", 17});                     // "apriltag-36h11-17"
//   tag_called("apriltag-36h11-17")->number;

#include <optional>
#include <string>
#include <string_view>

namespace pizarra::vision {

struct Tag {
  std::string family;  // apriltag-36h11, aruco-4x4-50, ...
  int number = 0;
  bool operator==(const Tag&) const = default;
};

std::string tag_name(const Tag& tag);
// Nothing where no family is called so.
std::optional<Tag> tag_called(std::string_view name);

}  // namespace pizarra::vision
