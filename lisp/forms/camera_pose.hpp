#pragma once

// Where a stereo camera stands in a cell: as its cell file says it, its driver renders it and the coordinator looks
// through it.
//
//   CameraPose pose{.at_mm = {1330, 0, 200}};   // before the arm, looking at it

#include <array>
#include <optional>

namespace pizarra::forms {

// A line that the camera turns about: a point of it, mm, and its direction, right-handed.
struct HeadAxis {
  std::array<double, 3> at_mm{};
  std::array<double, 3> along{};
  bool operator==(const HeadAxis&) const = default;
};

// Those of the pan-tilt unit under a camera, in the camera's own frame while the unit is in its middle: x to the right
// in the image, y down, z ahead. Pan turns the camera to the right, and the tilt axis with it; tilt turns it up.
struct HeadAxes {
  HeadAxis pan;   // mostly along y
  HeadAxis tilt;  // mostly along x
  bool operator==(const HeadAxes&) const = default;
};

// The base line's centre in the base frame. The pair looks along the base's -x, turned by pan (positive: towards +y,
// image right), then by tilt (positive: up), then by roll about its own axis (positive: its right side down).
struct CameraPose {
  std::array<double, 3> at_mm{1330, 0, 200};
  double pan_deg = 0;
  double tilt_deg = 0;
  double roll_deg = 0;
  // None: there is no unit, or its axes, one upright and one level, meet in the base line's centre.
  std::optional<HeadAxes> axes = std::nullopt;
  bool operator==(const CameraPose&) const = default;
};

// Where the agents take the camera to be, how sure that is (one standard deviation), and where the gripper's mark is in
// the tool's frame (drivers/arm/kinematics.hpp).
struct BelievedCamera {
  CameraPose pose;       // means nothing where it is unknown
  bool unknown = false;  // nobody has measured it
  double sure_mm = 1;
  double sure_deg = 0.1;
  std::array<double, 3> mark_mm{30, 0, -66};
};

}  // namespace pizarra::forms
