#pragma once

// A move as a program in URScript: its legs by movej and movel, blended, of an arm whose wrist 2 stands at -90 degrees.
//
//   move_script(model, legs, 0.5, from, 6)      // says 6 in integer register 24 when it begins, and 7 when it has
//   ended
//
// Facts from: Universal Robots, URScript manual.

#include <string>

#include "drivers/arm/route.hpp"

namespace pizarra::arm {

inline constexpr double wrist_2_deg = -90;

std::string move_script(const ArmModel& model, const std::vector<Leg>& legs, double speed, const Joints& from,
                        std::int32_t begun);

}  // namespace pizarra::arm
