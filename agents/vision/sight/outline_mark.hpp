#pragma once

// A mark that a registered outline shows where no region of the image does: a shadow's edge that runs beside it, or
// what it lies against, takes it for its own.
//
//   const SeenMark mark = mark_by_outline(last, sample.plane, fit);

#include "agents/vision/marks/mark_measure.hpp"
#include "agents/vision/marks/plane_fit.hpp"

namespace pizarra::vision {

// Its place and its size are those of the outline, its levels and its form those that it had in `last`.
SeenMark mark_by_outline(const SeenMark& last, const PlaneOutline& outline, const PlaneFit& fit);

}  // namespace pizarra::vision
