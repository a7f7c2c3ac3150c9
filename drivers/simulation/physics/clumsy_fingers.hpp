#pragma once

// Fingers that drop and misplace what they hold, as those of published experiments do: what is held slips out of them
// in flight, and what is put down comes to lie off where it was put. Nothing is clumsy until it is asked for.
//
//   ClumsyFingers fingers(physics, gripper, random);
//   fingers.slips({.chance = 0.15, .draws = 1, .within_s = 6});     // from the next grasp on
//   fingers.misplaces(0.5);                                         // from the next placement on
//   fingers.step(1.0 / 240);                                        // after the gripper's step
//
// A carry begins with a grasp. Each of its draws has an instant of its own, uniform in the time after the grasp; one
// that comes after the cube was put down changes nothing. The same seed and the same grasps give the same mishaps.

#include <vector>

#include "blackboard/time/random.hpp"
#include "drivers/simulation/physics/gripper.hpp"

namespace pizarra::simulation {

class ClumsyFingers {
 public:
  static constexpr int most_draws = 10;

  struct Slips {
    double chance = 0;  // of each draw
    int draws = 1;      // a carry
    double within_s = 6;
  };

  ClumsyFingers(Physics& physics, Gripper& gripper, Random random)
      : physics_(physics), gripper_(gripper), random_(std::move(random)) {}

  void slips(const Slips& slips) { slips_ = slips; }
  // By up to this part of the cube's edge, to any side, uniformly far.
  void misplaces(double part_of_edge) { misplaces_ = part_of_edge; }
  void step(double seconds);
  // Whether time alone will make something slip.
  bool is_about_to_slip() const { return !slip_after_s_.empty(); }

 private:
  void begin_carry();
  void put_off(DynamicId cube);
  bool is_free(DynamicId cube, const Eigen::Vector3d& at) const;

  Physics& physics_;
  Gripper& gripper_;
  Random random_;
  Slips slips_;
  double misplaces_ = 0;
  std::optional<DynamicId> carried_;
  std::vector<double> slip_after_s_;  // of this carry, counted from now
};

}  // namespace pizarra::simulation
