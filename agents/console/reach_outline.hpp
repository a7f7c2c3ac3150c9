#pragma once

// How far an arm reaches over the table with its tool down, and its track where the arm begins work: for each direction
// around the arm's foot from where to where, in the base frame, from x towards y.
//
//   const ReachOutline reach = reach_outline(model, 30);      // the grip 30 mm above the table

#include <vector>

#include "drivers/arm/arm_model.hpp"

namespace pizarra::console {

struct ReachOutline {
  struct Part {
    double from_mm = 0;
    double to_mm = 0;  // 0: nowhere in this direction
  };
  double height_mm = 0;
  std::vector<Part> parts;  // all around, equally far apart
};

ReachOutline reach_outline(const arm::ArmModel& model, double height_mm);

}  // namespace pizarra::console
