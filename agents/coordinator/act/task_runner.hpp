#pragma once

// Does tasks: an operation of the plan is one, and so is what a rescue (rescues.hpp) improvises. A task is its
// micro-tasks (plan/primitives.hpp) one after another, the aligning ones under the visual servo.
//
//   conditions.begin(operation, needed_after);
//   Result<void> done = co_await runner.run(index, operation);
//
// Failures: interrupted and difference, those of StandingConditions::check(); camera-doubtful: it may have been moved;
// missed: nothing was grasped; slipped: what was carried is not between the fingers any more; no-effect: all was done,
// and the eyes do not see its effect. Others are lost-sight, no-convergence, no-room, absent, and the robot's own.

#include "agents/coordinator/act/carried.hpp"
#include "agents/coordinator/act/pushes.hpp"
#include "agents/coordinator/act/servo_loop.hpp"

namespace pizarra::coordinator {

class TaskRunner {
 public:
  TaskRunner(runtime::AgentContext& context, const CoordinatorOptions& options, const TaskDomain& domain,
             Surroundings& surroundings, Story& story, Arm& arm, Eyes& eyes, const Interruption& interruption,
             StandingConditions& conditions, Aims& aims, Carried& carried, ServoLoop& servo, Pushes& pushes)
      : context_(context),
        options_(options),
        domain_(domain),
        surroundings_(surroundings),
        story_(story),
        arm_(arm),
        eyes_(eyes),
        interruption_(interruption),
        conditions_(conditions),
        aims_(aims),
        carried_(carried),
        servo_(servo),
        pushes_(pushes) {}

  Task<Result<void>> run(std::size_t index, GroundOperation operation);
  // Micro-tasks that belong to no operation: nothing has to go on holding meanwhile.
  Task<Result<void>> improvise(std::vector<Datum> steps);
  // Up, or down, to the height that is safe to travel at, with the end effector in sight.
  Task<Result<void>> raise() { return raise_to(options_.travel_height_mm); }

 private:
  Task<Result<void>> raise_to(double height_mm);
  // By as much, inwards where the arm does not reach as high.
  Task<Result<void>> go_up(double missing_mm, double height_mm);
  // Looks whether the raised arm's mark is seen.
  Task<Result<void>> look_for_mark(bool has_moved);
  Task<Result<void>> run_steps(std::vector<Datum> steps);
  Task<Result<void>> run_step(Datum step);
  Task<Result<void>> open(double opening_mm);
  Task<Result<void>> turn_fingers(std::string object);
  Task<Result<void>> close();
  Task<Result<void>> release();
  Task<Result<void>> check_held(std::string object);
  Task<Result<void>> await_effects(GroundOperation operation);
  Task<Result<Revision>> tell(const Datum& fact);

  runtime::AgentContext& context_;
  const CoordinatorOptions& options_;
  const TaskDomain& domain_;
  Surroundings& surroundings_;
  Story& story_;
  Arm& arm_;
  Eyes& eyes_;
  const Interruption& interruption_;
  StandingConditions& conditions_;
  Aims& aims_;
  Carried& carried_;
  ServoLoop& servo_;
  Pushes& pushes_;
};

}  // namespace pizarra::coordinator
