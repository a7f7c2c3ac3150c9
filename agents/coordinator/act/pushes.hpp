#pragma once

// Objects pushed with the closed fingers: out of a row, where a neighbour stands too close for the fingers, or over, so
// that they lie otherwise; or from beside the images to where they show.
//
//   Pushes pushes(options, domain, surroundings, story, arm, conditions);
//   Result<void> done = co_await pushes.make_room("circle");       // nothing where there is room
//
// Failures: interrupted, difference, camera-doubtful (see may_move in servo_loop.hpp), lost-sight, and the robot's own.

#include <optional>
#include <string>

#include "agents/coordinator/act/arm.hpp"
#include "agents/coordinator/geometry/elbow_room.hpp"
#include "agents/coordinator/perceive/surroundings.hpp"
#include "agents/coordinator/plan/standing_conditions.hpp"

namespace pizarra::coordinator {

class Pushes {
 public:
  Pushes(const CoordinatorOptions& options, const TaskDomain& domain, const Surroundings& surroundings, Story& story,
         Arm& arm, StandingConditions& conditions)
      : options_(options),
        domain_(domain),
        surroundings_(surroundings),
        story_(story),
        arm_(arm),
        conditions_(conditions) {}

  Task<Result<void>> make_room(std::string object);
  // A cube at the side of the images is swept instead, to where all of it shows.
  Task<Result<void>> push_over(std::string object);
  // Whether the images cut off, wholly or in part, the place on the table where it was seen last.
  bool lay_cut_off(const std::string& object) const;
  // Of an object that the side of the images cuts off; none where it does not, or there is no room to sweep it.
  std::optional<Push> sweep_inwards(const std::string& object) const;
  // First pushes of others that the images cut off, since they may hide it; then sweeps of the table beside the images,
  // and grips before them, where it may lie, the likeliest first. `was_here`: one that was never seen may lie anywhere.
  std::vector<Push> sweeps_for(const std::string& missing, bool was_here) const;
  // What was lifted is between the fingers then.
  Task<Result<void>> sweep(Push push);

 private:
  Task<Result<void>> lift_at(Push push, double height_mm);
  Task<Result<void>> push_along(Push push, double height_mm);
  ElbowRoom elbow_room() const;
  std::optional<Push> push_for(std::string_view object) const;
  // Of others that are not seen any more and lie where the images cut them off, as after a knock against the camera.
  std::vector<Push> pushes_into_view(const std::string& missing) const;
  // The middles of the cubes that are there but for this one.
  std::vector<Eigen::Vector3d> standing_but(const std::string& object) const;

  const CoordinatorOptions& options_;
  const TaskDomain& domain_;
  const Surroundings& surroundings_;
  Story& story_;
  Arm& arm_;
  StandingConditions& conditions_;
};

}  // namespace pizarra::coordinator
