#pragma once

// Whoever plays the robot, as the coordinator uses it: motions that answer when they have ended. An agent that is away
// is waited for, a busy one asked again; both have their bounds.
//
//   Result<void> moved = co_await arm.perform(command);
//   Result<double> opening = co_await arm.grip(0);

#include <Eigen/Core>

#include "agents/coordinator/geometry/servo.hpp"
#include "agents/coordinator/options.hpp"
#include "agents/coordinator/story.hpp"
#include "agents/runtime/roles.hpp"

namespace pizarra::coordinator {

class Arm {
 public:
  Arm(runtime::AgentContext& context, const CoordinatorOptions& options, runtime::Roles& roles, runtime::Caller& caller,
      Story& story)
      : context_(context), options_(options), roles_(roles), caller_(caller), story_(story) {}

  // One robot operation. Failures: those of the robot, `absent` when it stays away too long, and `stopped` where
  // another robot stands in for the one that was moving.
  Task<Result<Datum>> ask(Datum operation);
  // Carries out the servo's decision, as far as the arm goes. A turn is taken back by the wrist, so that the fingers
  // stay along the base's y. Failure `unreachable`: a line along which the arm goes no further at all.
  Task<Result<void>> perform(ServoCommand command);
  // The robot has a request of ours and has not answered. It answers at once while it moves for somebody else.
  bool is_asked() const { return asked_.has_value(); }
  // Ends the motion of that request, and no other, and answers when the arm stands.
  Task<Result<void>> cut_short();
  // The grip centre in a straight line to a point of the base frame, carried on by a track where the links end.
  Task<Result<void>> move_to(Eigen::Vector3d point_mm);
  // The speed that somebody set for its motions, 1 to 100; 100 where nobody did.
  Task<double> speed_percent();
  // Where the grip centre is, base frame, mm.
  Task<Result<Eigen::Vector3d>> grip_centre();
  // Turns the wrist until the gripper's front looks `yaw_deg` away from the base's x axis, positive to the right.
  Task<Result<void>> face(double yaw_deg);
  // Opens or closes the gripper to `opening_mm` and answers the opening it came to.
  Task<Result<double>> grip(double opening_mm);

 private:
  runtime::AgentContext& context_;
  const CoordinatorOptions& options_;
  runtime::Roles& roles_;
  runtime::Caller& caller_;
  Story& story_;
  std::optional<Datum> asked_;  // the ID of the request that is not answered yet
};

// Whether a motion ended as cut_short() asked for that, and nobody else did.
bool was_cut_short(const Failure& why);
// Whether a motion ended as a line fell silent, to the board or to the arm: nothing was in its way.
bool met_silence(const Failure& why);
// Whether a motion was refused since the arm does not come there.
bool is_beyond_reach(const Failure& why);

}  // namespace pizarra::coordinator
