#pragma once

// The physical cell, step by step and without a clock: cubes, arm, gripper and hand together.
//
//   Cell cell(config);
//   cell.step();                                   // 1/240 s
//   Snapshot now = cell.snapshot();
//
// The arm stops by itself where it meets resistance that grows: its gripper presses on the table or on a cube, or what
// it holds is pressed on something.

#include "drivers/simulation/physics/arm_motion.hpp"
#include "drivers/simulation/physics/clumsy_fingers.hpp"
#include "drivers/simulation/physics/hand.hpp"
#include "drivers/simulation/render/scene.hpp"

namespace pizarra::simulation {

// Names of objects are compared without case.
bool names_agree(std::string_view a, std::string_view b);

class Cell {
 public:
  // Of a checked config, which outlives it.
  explicit Cell(const WorldConfig& config);

  void step();
  // A step would change nothing.
  bool at_rest() const;

  Snapshot snapshot() const;
  Scene scene() const { return moving_scene(config_, snapshot()); }
  Pose tool() const;
  // The cube's number; names are compared without case. Failure: unknown-object.
  Result<DynamicId> find(std::string_view name) const;
  // A cube of that name, away until the hand brings it; one that is away already is answered. Failure: bad-request.
  Result<DynamicId> prepare(std::string_view name, const FaceMark& mark);
  const std::string& name(DynamicId cube) const { return cubes_[cube].name; }
  const CubeMarks& marks(DynamicId cube) const { return cubes_[cube].marks; }
  // It bears no marks.
  bool is_thing(DynamicId cube) const { return !cubes_[cube].marks.front(); }

  const Physics& physics() const { return physics_; }
  ArmMotion& arm() { return arm_; }
  Gripper& gripper() { return gripper_; }
  const Gripper& gripper() const { return gripper_; }
  ClumsyFingers& fingers() { return fingers_; }
  Hand& hand() { return hand_; }
  const Hand& hand() const { return hand_; }

 private:
  struct CubeInfo {
    std::string name;
    CubeMarks marks;
  };
  struct Load {
    double force_n = 0;
    double depth_mm = 0;
    double lowest_mm = 0;
  };
  void place_cubes();
  void place_things();
  Load load() const;
  void protect();

  const WorldConfig& config_;
  Physics physics_;
  ArmMotion arm_;
  Gripper gripper_;
  ClumsyFingers fingers_;
  Hand hand_;
  std::vector<CubeInfo> cubes_;
  Load before_;  // as it was when the move under way began
  double lowest_before_mm_ = 0;
  int pressing_steps_ = 0;
  bool was_moving_ = false;
};

}  // namespace pizarra::simulation
