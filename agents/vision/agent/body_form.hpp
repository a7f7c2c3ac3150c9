#pragma once

// A body as clients and cell files write it: its marks, and where they are on it.
//
//   const Result<Body> box = body_from(read_one("((\"front\" (0 0 -25) (0 0 0)) ...)").value(), "box");

#include "agents/vision/sight/body_pose.hpp"
#include "lisp/result.hpp"

namespace pizarra::vision {

inline constexpr std::size_t most_marks_of_a_body = 12;
inline constexpr double farthest_on_a_body_mm = 2000;

// `marks`: ((MARK (X Y Z) (RX RY RZ)) ...), mm and degrees about x, then y, then z. Failures: `malformed`, and `twice`
// of a mark.
Result<Body> body_from(const Datum& marks, const std::string& name);

}  // namespace pizarra::vision
