#pragma once

// The two links of an arm as a triangle, for Extend and Retract (thesis, tables B.3 and B.4).
//
//   th1, th2 -> C = 180 - th1 + th2, c^2 = a^2 + b^2 - 2ab cos C, B = acos((a^2 + c^2 - b^2) / (2ac)),
//   alpha = th1 - B, h = c sin alpha, d = c cos alpha; and back from h and d.
//
// B takes the sign that the elbow has, which the printed formula leaves out: positive with the elbow above.
//
//   LinkGeometry links = link_geometry(model, joints);
//   links.d_mm += 20;                                   // extended by 20 at the same height
//   std::optional<LinkJoints> moved = link_joints(model, links);

#include <optional>

#include "drivers/arm/arm_model.hpp"

namespace pizarra {

// The wrist centre as seen from axis 2: h above, d ahead, c away, in the direction alpha above the horizontal.
struct LinkGeometry {
  double h_mm;
  double d_mm;
  double c_mm;
  double alpha_deg;
  bool elbow_above;
};

struct LinkJoints {
  double j2_deg;
  double j3_deg;
};

LinkGeometry link_geometry(const ArmModel& model, const Joints& joints);

// j2 and j3 for the wrist centre at `links.h_mm`, `links.d_mm` with the elbow on the same side; nothing where the links
// do not reach. Limits are not looked at.
std::optional<LinkJoints> link_joints(const ArmModel& model, const LinkGeometry& links);

}  // namespace pizarra
