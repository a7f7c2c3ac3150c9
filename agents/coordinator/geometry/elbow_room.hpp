#pragma once

// Room for the fingers between cubes that stand side by side, and for the palm beside high piles: where there is none,
// the cube that is wanted is pushed out of the row, towards the camera or away from it, by the fingers held a hand's
// breadth apart.
//
//   if (is_crowded(room, centre, others)) push = push_for_room(room, centre, others);

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

namespace pizarra::coordinator {

struct ElbowRoom {
  double cube_mm = 60;
  double finger_mm = 8;        // thickness, sideways
  double finger_half_mm = 12;  // half its width, towards the camera
  double narrow_mm = 76;       // the smallest opening that goes around a cube
  double pusher_mm = 36;       // the opening to push with: both fingers touch the cube's face
  double push_height_mm = 42;  // of the grip centre, while it pushes
  double palm_half_mm = 62;    // half its width, as wide as the fingers can stand apart
  double palm_deep_mm = 20;    // half its depth, across that
  double palm_above_mm = 84;   // from the grip centre up to where it begins
  double margin_mm = 3;
  double fingers_deg = 0;    // how they are turned to grasp, as Arm::face() has it; at 0 they stand apart along y
  double mark_half_mm = 22;  // from a mark's middle to its edge
  // Where each image is taken from, base frame; none: whether marks are seen is not asked.
  std::vector<Eigen::Vector3d> eyes_mm = {};
  // Whether both images show the face with the mark of a cube whose centre is there; none: that is not asked.
  std::function<bool(const Eigen::Vector3d& centre)> shown = {};
  double reach_low_mm = 310;  // radius from the arm's axis
  // Further out than a cube is put down: a push that the arm cannot reach is refused before it moves.
  double reach_high_mm = 600;
  double wide_mm = 96;        // the largest opening
  double grip_high_mm = 610;  // radius from which the arm goes straight down
};

// A straight push over the table, grip centre, base frame.
struct Push {
  Eigen::Vector2d from_mm;
  Eigen::Vector2d to_mm;
  double face_deg = 0;  // how the gripper is turned, as Arm::face() has it; at 0 the fingers stand apart along y
  // The open fingers go down around what lies where it begins, close on it, and lift it: nothing is pushed.
  bool lifts = false;
};

// Where the others stand to fingers around `centre` that are turned so far: as they would to fingers at 0.
std::vector<Eigen::Vector3d> seen_from_fingers(double fingers_deg, const Eigen::Vector3d& centre,
                                               std::vector<Eigen::Vector3d> others);

// Whether a neighbour stands where a finger must go at the cube's height, or is high enough to meet the palm.
bool is_crowded(const ElbowRoom& room, const Eigen::Vector3d& centre, const std::vector<Eigen::Vector3d>& others);

// The push that gives a crowded cube its room, if possible one that leaves all marks in sight; none where the way, or
// the place to push from, is taken or out of reach, or where it would leave the images. Beside a high pile the gripper
// is turned, so that the palm passes. A cube on another goes with it, but only away from the camera, since the plate
// with the gripper's mark would touch it. All points are cubes' centres.
std::optional<Push> push_for_room(const ElbowRoom& room, const Eigen::Vector3d& centre,
                                  const std::vector<Eigen::Vector3d>& others);

// The shortest push that takes what the images cut off to where all of it shows; none where it shows already, or the
// arm has no room to push it.
std::optional<Push> push_into_view(const ElbowRoom& room, const Eigen::Vector3d& centre,
                                   const std::vector<Eigen::Vector3d>& others);

// The push that takes a cube which lies askew half a cube's size on, off what it leans on: towards the camera, where it
// then stands before what held it up, unless it would leave the images.
Push push_over_from(const ElbowRoom& room, const Eigen::Vector3d& centre);

}  // namespace pizarra::coordinator
