#pragma once

// The visual servo: look, decide, move, until the end effector is where a target wants it (states 1 to 4 of the
// thesis).
//
//   ServoLoop servo(context, options, service, surroundings, story, arm, eyes, conditions, aims, carried);
//   Result<void> there = co_await servo.run(target, false);      // true: goes down to it
//
// Failures: interrupted, difference, camera-doubtful (see may_move), lost-sight, no-convergence, those of the aim
// (no-room, unknown-place), and the robot's own.

#include "agents/coordinator/act/aim.hpp"
#include "agents/coordinator/act/arm.hpp"
#include "agents/coordinator/act/carried.hpp"
#include "agents/coordinator/perceive/eyes.hpp"
#include "agents/coordinator/plan/standing_conditions.hpp"

namespace pizarra::coordinator {

// Before every motion of a task. Failures: those of StandingConditions::check(); camera-doubtful: it may have been
// moved.
Result<void> may_move(const Surroundings& surroundings, const StandingConditions& conditions);

class ServoLoop {
 public:
  ServoLoop(runtime::AgentContext& context, const CoordinatorOptions& options, const runtime::Service& service,
            Surroundings& surroundings, Story& story, Arm& arm, Eyes& eyes, const StandingConditions& conditions,
            Aims& aims, Carried& carried)
      : context_(context),
        options_(options),
        service_(service),
        surroundings_(surroundings),
        story_(story),
        arm_(arm),
        eyes_(eyes),
        conditions_(conditions),
        aims_(aims),
        carried_(carried) {}

  Task<Result<void>> run(Datum target, bool descend);
  // What the servo makes up for: (servo STATE TARGET ERR-X ERR-Y ERR-D).
  Task<Result<Revision>> tell(int state, const Datum& target, ServoPixels errors);

 private:
  Task<Result<void>> go_straight(Aim aim, ServoCommand stalled);
  Task<Result<void>> go_down(double down_mm);
  // Carries the command out; false where it was cut short, as its target had been moved meanwhile.
  Task<Result<bool>> move(Datum target, Aim aim, ServoCommand command, bool stalled);
  // Beside a motion: ends it once a look shows that its target is elsewhere than the motion was decided for.
  struct Cut;
  Task<void> cut_short(Datum target, Eigen::Vector3d wanted_mm, Cut& cut);

  runtime::AgentContext& context_;
  const CoordinatorOptions& options_;
  const runtime::Service& service_;
  Surroundings& surroundings_;
  Story& story_;
  Arm& arm_;
  Eyes& eyes_;
  const StandingConditions& conditions_;
  Aims& aims_;
  Carried& carried_;
};

}  // namespace pizarra::coordinator
