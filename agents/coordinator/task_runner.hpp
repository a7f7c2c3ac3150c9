#pragma once

// Does one operation of the plan: its micro-tasks one after another, the aligning ones under the visual servo.
//
//   vigil.begin(table, index);
//   Result<void> done = co_await runner.run(index, operation);
//
// Failures: interrupted, difference (see Vigil), missed (nothing was grasped), lost-sight, no-convergence, no-effect
// (all was done and the eyes do not see its effect), no-room, absent, and the robot's own.

#include "agents/coordinator/aim.hpp"
#include "agents/coordinator/arm.hpp"
#include "agents/coordinator/elbow_room.hpp"
#include "agents/coordinator/eyes.hpp"
#include "agents/coordinator/vigil.hpp"

namespace pizarra {

class TaskRunner {
 public:
  TaskRunner(AgentContext& context, const CoordinatorOptions& options, const TaskDomain& domain, const Service& service,
             Surroundings& surroundings, Story& story, Arm& arm, Eyes& eyes, Vigil& vigil)
      : context_(context),
        options_(options),
        domain_(domain),
        service_(service),
        surroundings_(surroundings),
        story_(story),
        arm_(arm),
        eyes_(eyes),
        vigil_(vigil),
        aims_(options, domain, surroundings) {}

  Task<Result<void>> run(std::size_t index, GroundOperation operation);
  // Puts down on a free spot whatever the gripper holds, `object` or another, so that the eyes can tell what it is.
  // Nothing is done where it holds nothing.
  Task<Result<void>> lay_down(std::string object);
  // Takes `object` to a free spot, away from what it may hide.
  Task<Result<void>> set_aside(std::string object);
  // Pushes what cannot be grasped where it lies, so that it lies otherwise. What is held already is laid down, and
  // `onto`, which it could not be put on, pushed out of its row where it is crowded.
  Task<Result<void>> loosen(std::string object, std::string onto);
  // Up, or down, to the height that is safe to travel at, with the end effector in sight.
  Task<Result<void>> raise();

 private:
  Task<Result<void>> run_steps(std::vector<Datum> steps);
  Task<Result<void>> run_step(Datum step);
  Task<Result<void>> servo(Datum target, bool descend);
  Task<Result<void>> open(double opening_mm);
  Task<Result<void>> turn_fingers(std::string object);
  Task<Result<void>> close();
  Task<Result<void>> release();
  Task<Result<void>> make_room(std::string object);
  Task<Result<void>> push_over(std::string object);
  Task<Result<void>> push_along(Push push, double height_mm);
  std::optional<Push> push_for(std::string_view object) const;
  Task<Result<void>> check_held(std::string object);
  Task<Result<void>> await_effects(GroundOperation operation);
  Task<Result<Revision>> tell_servo(int state, const Datum& target, const Aim& aim);
  Task<Result<Revision>> tell(const Datum& fact);
  Result<void> check() const { return vigil_.check(surroundings_.beliefs()); }

  AgentContext& context_;
  const CoordinatorOptions& options_;
  const TaskDomain& domain_;
  const Service& service_;
  Surroundings& surroundings_;
  Story& story_;
  Arm& arm_;
  Eyes& eyes_;
  Vigil& vigil_;
  Aims aims_;
};

}  // namespace pizarra
