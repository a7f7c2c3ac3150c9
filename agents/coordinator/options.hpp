#pragma once

// The options of a coordinator that a cell configures, and the constants beside them. Lengths mm. The options are set
// before it runs.
//
//   CoordinatorOptions options;
//   options.domain_file = "domains/blocks.scm";
//   CoordinatorAgent coordinator(context, options);

#include <optional>
#include <string>

#include "agents/coordinator/geometry/camera_view.hpp"
#include "blackboard/time/clock.hpp"
#include "lisp/forms/cell_file.hpp"

namespace pizarra::coordinator {

// The gripper as the camera sees it, around the point where the mark of a held object would stand. A mark behind it is
// not lost: nothing is known of it until the gripper has moved on (lisp/modules/pizarra/looks.scm decides it).
struct GripperOutline {
  static constexpr double half_width_mm = 62;  // of the palm
  static constexpr double below_mm = 32;       // fingertips, or what is held
  static constexpr double mark_half_mm = 24;   // an object's mark that is partly covered is not recognised either
};

// The gripper and its mark, as they are built.
struct GripperGeometry {
  std::string mark = "end-effector";  // the name it was learned under
  double mark_above_grip_mm = 66;
  double mark_before_grip_mm = 30;  // towards the camera
  static constexpr double finger_mm = 8;
  // The lowest that the grip centre may go, above what a cube stands on, for the fingertips to clear that.
  static constexpr double finger_below_mm = 22;
  forms::GripperOpenings openings;
  GripperOutline outline;
};

struct CoordinatorOptions {
  std::string domain_file;
  forms::BelievedCamera camera;
  bool head = false;  // whether the camera stands on a pan-tilt unit, whose (head ...) fact says how it is turned
  GripperGeometry gripper;
  forms::CubeRow row;                        // where cubes are put down
  std::optional<double> cube_mm;             // of the largest; none: those that the domain was written for
  forms::EdgesMm edges_mm;                   // of cubes by their names; the others are as large as the largest
  double travel_height_mm = 300;             // of the grip: clears a tower of four
  static constexpr double release_mm = 1.5;  // above the support, where a held cube is let go
  // The first plan is carried out blindly: nothing is checked or planned again. To compare with; never of use.
  bool open_loop = false;

  static constexpr int belief_looks = 3;  // in a row, before a difference counts
  static constexpr int grace_looks = 10;  // unseen for as long, an object's facts go
  static constexpr Duration settle = 2s;  // the goal must hold for as long before it counts as reached,
  static constexpr int settle_looks = 5;  // and in so many looks: while none come, nobody sees whether it does
  static constexpr Duration effects_patience = 3s;   // how long an operation's effects may take to show
  static constexpr Duration missing_patience = 6s;   // how long a needed object is looked for
  static constexpr Duration absence_patience = 20s;  // how long an agent that died is waited for
};

}  // namespace pizarra::coordinator
