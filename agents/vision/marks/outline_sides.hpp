#pragma once

// The sides of an outline: what a straight edge that covers a part of the mark may be taken for. All places of one side
// lie about on one line and look the same way; an arc has several. The few places that turn about a corner have no
// side: a cover that is taken for one of the sides there moves them too.
//
//   number_sides(outline.points);       // outline.points.front().side ...

#include <vector>

#include "agents/vision/marks/outline_point.hpp"

namespace pizarra::vision {

void number_sides(std::vector<OutlinePoint>& points);

}  // namespace pizarra::vision
