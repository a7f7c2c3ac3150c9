#pragma once

// Pursues one goal, or one stage of it: the thesis' steps a to h, until it holds or cannot.
//
// Its rounds: the planner, which owns the plan, is told what is believed and hands out the operation to do next. No end
// of the plan serves: a new plan. Nothing is left to do: watch for a while that the goal stays. A belief that holds no
// more is told as a difference, with the frame that showed it. So is the consequence: which part of the plan in hand
// still serves, or the new plan. The goal is a durable fact, from which a new life of the coordinator goes on; the plan
// is the planner's.
//
//   Result<void> outcome = co_await pursuit.run(goal);       // interrupted where another goal, or none, is wanted

#include <map>
#include <optional>

#include "agents/coordinator/act/camera_survey.hpp"
#include "agents/coordinator/act/rescues.hpp"
#include "agents/coordinator/act/task_runner.hpp"
#include "agents/coordinator/pursue/differences.hpp"
#include "agents/coordinator/pursue/hold_up.hpp"
#include "agents/coordinator/pursue/replanning.hpp"
#include "agents/coordinator/pursue/room_to_see.hpp"

namespace pizarra::coordinator {

class Pursuit {
 public:
  Pursuit(runtime::AgentContext& context, const CoordinatorOptions& options, const TaskDomain& domain,
          Surroundings& surroundings, Story& story, Eyes& eyes, Planning& planning, PlanInHand& plan,
          Differences& differences, ObjectSearch& search, Replanning& replanning, TaskRunner& runner, Rescues& rescues,
          CameraSurvey& survey, const Interruption& interruption, StandingConditions& conditions)
      : context_(context),
        options_(options),
        domain_(domain),
        surroundings_(surroundings),
        story_(story),
        eyes_(eyes),
        planning_(planning),
        plan_(plan),
        differences_(differences),
        search_(search),
        replanning_(replanning),
        runner_(runner),
        rescues_(rescues),
        survey_(survey),
        interruption_(interruption),
        conditions_(conditions),
        room_(surroundings, search, rescues),
        hold_up_(context, story, interruption) {}

  Task<Result<void>> run(Goal goal);

 private:
  // How far the rounds of one goal have come.
  struct Progress {
    std::optional<NextOperation> expected;   // what is handed out next unless something differs
    std::optional<std::size_t> announced;    // the one that the story has said to be next
    std::map<Datum, int> failures_of;        // of each operation, since it succeeded
    std::map<Datum, int> failures_in_a_row;  // since any did
    int failures = 0;
    int plans = 0;
  };

  // Until it holds, cannot, or something holds the cell up.
  Task<Result<void>> attempt(Goal goal);
  Task<Result<void>> rounds(Goal goal);
  // Where it is not known well enough, or no more, where the camera stands.
  Task<Result<void>> find_camera();
  // The first plan, whatever comes of it.
  Task<Result<void>> carry_out_blindly(Goal goal);
  // The operation to go on with; none where a plan had to be made first.
  Task<Result<std::optional<NextOperation>>> choose(Goal goal, Progress& progress);
  // Takes note of a failed operation; a failure where it is to be the last.
  Task<Result<void>> recover(std::int64_t goal, GroundOperation operation, Failure why, Progress& progress);
  Task<Result<void>> recover_from_slip(GroundOperation operation, Failure why, Progress& progress);
  // Changes the scene where trying the same again would end the same way.
  Task<void> try_otherwise(std::int64_t goal, GroundOperation operation, Failure why);
  Task<Result<void>> do_operation(NextOperation next);
  // Whether it is about an object that came after the plan was made, and does not hold of that.
  bool outgrows_plan(const Goal& goal) const;
  // Whether the goal still held after the time to settle.
  Task<bool> settles(Goal goal);
  // Those of the goal; where it is about some or all of a type, all that are seen.
  std::vector<std::string> objects_to_lie_still(const Goal& goal) const;
  std::vector<std::string> objects_of(const Goal& goal) const { return domain_.objects_in(goal.facts); }

  runtime::AgentContext& context_;
  const CoordinatorOptions& options_;
  const TaskDomain& domain_;
  Surroundings& surroundings_;
  Story& story_;
  Eyes& eyes_;
  Planning& planning_;
  PlanInHand& plan_;
  Differences& differences_;
  ObjectSearch& search_;
  Replanning& replanning_;
  TaskRunner& runner_;
  Rescues& rescues_;
  CameraSurvey& survey_;
  const Interruption& interruption_;
  StandingConditions& conditions_;
  RoomToSee room_;
  HoldUp hold_up_;
};

}  // namespace pizarra::coordinator
