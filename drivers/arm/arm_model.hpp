#pragma once

// An arm described as data: link geometry, limits, speeds and the meaning of its axes, in the thesis' convention.
// Lengths mm, angles degrees. Sources: link geometry and speeds of the CRS-F3 (the KUKA KR3's): d1 350, a1 100, a2 265,
// d4 270, d6 75; signs and limits: the thesis' Table B.1.

#include <array>
#include <string>
#include <string_view>

namespace pizarra {

inline constexpr std::size_t arm_axes = 6;
using Joints = std::array<double, arm_axes>;  // degrees

struct AxisLimits {
  double low_deg;
  double high_deg;
  double speed_deg_s;
};

struct ArmModel {
  std::string type;
  double base_height_mm;  // axis 2 above the table
  double base_offset_mm;  // axis 2 ahead of axis 1
  double upper_arm_mm;    // a
  double forearm_mm;      // b, elbow to wrist centre
  double wrist_mm;        // wrist centre to flange
  double tool_mm;         // flange to grip centre
  std::array<AxisLimits, arm_axes> limits;
  Joints home;   // folded high above the table, tool down, out of the way of whatever looks at it
  Joints ready;  // where work begins: for the CRS-F3 the 90-degree pose, upper arm up, forearm level, tool down
};

// What the controller of this model calls itself, or nothing where the type is unknown.
const ArmModel* arm_model(std::string_view type);

const ArmModel& crs_f3();

}  // namespace pizarra
