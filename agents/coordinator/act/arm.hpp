#pragma once

// The robot agent as the coordinator uses it: motions that answer when they have ended. An agent that is away is waited
// for, a busy one asked again; both have their bounds.
//
//   Result<void> moved = co_await arm.perform(command);
//   Result<double> opening = co_await arm.grip(0);

#include <Eigen/Core>

#include "agents/coordinator/event_log.hpp"
#include "agents/coordinator/geometry/servo.hpp"
#include "agents/coordinator/options.hpp"
#include "agents/coordinator/perceive/presence.hpp"
#include "agents/runtime/service.hpp"

namespace pizarra::coordinator {

class Arm {
 public:
  Arm(runtime::AgentContext& context, const CoordinatorOptions& options, Presence& presence, Story& story,
      runtime::Caller& caller)
      : context_(context), options_(options), presence_(presence), story_(story), caller_(caller) {}

  // One robot operation. Failures: those of the robot, and `absent` when it stays away too long.
  Task<Result<Datum>> ask(Datum operation);
  // What the servo decided. A turn is taken back by the wrist, so that the fingers stay along the base's y.
  Task<Result<void>> perform(ServoCommand command);
  // Where the grip centre is, base frame, mm.
  Task<Result<Eigen::Vector3d>> grip_centre();
  // Turns the wrist until the gripper's front looks `yaw_deg` away from the base's x axis, positive to the right.
  Task<Result<void>> face(double yaw_deg);
  // Opens or closes the gripper to `opening_mm` and answers the opening it came to.
  Task<Result<double>> grip(double opening_mm);

 private:
  runtime::AgentContext& context_;
  const CoordinatorOptions& options_;
  Presence& presence_;
  Story& story_;
  runtime::Caller& caller_;
};

}  // namespace pizarra::coordinator
