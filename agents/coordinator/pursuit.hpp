#pragma once

// Pursues the goal: the thesis' steps a to h, one goal at a time, until it holds or cannot.
//
// Its rounds: which suffix of the plan can go on from what is believed (triangle table)? None: a new plan. The empty
// one: watch for a while that the goal stays. Any other: do its first operation. What was believed and is not any more
// is told as a difference, with the frame that showed it. Goal, plan and operation are durable facts, from which a new
// life of the coordinator goes on.

#include "agents/coordinator/planning.hpp"
#include "agents/coordinator/task_runner.hpp"

namespace pizarra {

class Pursuit {
 public:
  Pursuit(AgentContext& context, const CoordinatorOptions& options, const TaskDomain& domain,
          Surroundings& surroundings, Story& story, Eyes& eyes, Planning& planning, TaskRunner& runner, Vigil& vigil)
      : context_(context),
        options_(options),
        domain_(domain),
        surroundings_(surroundings),
        story_(story),
        eyes_(eyes),
        planning_(planning),
        runner_(runner),
        vigil_(vigil),
        wanted_(context.executor) {}

  // Goes on for ever, one goal after another.
  Task<void> run();
  // Takes a checked goal, instead of the one in hand, and answers its number.
  Task<Result<std::int64_t>> submit(std::vector<Datum> facts);
  // Whether there was a goal to give up.
  Task<bool> cancel();

 private:
  struct Goal {
    std::int64_t number;
    std::vector<Datum> facts;
  };

  Task<void> resume();
  Task<Result<void>> pursue(Goal goal);
  Task<Result<void>> rounds(Goal goal);
  Task<Result<void>> look_for(std::vector<std::string> objects);
  Task<Result<void>> look_once_for(std::string object, Time deadline);
  Task<Result<void>> clear_view(std::string missing);
  Task<void> loosen(Datum operation);
  Task<void> await_steady(std::vector<std::string> objects);
  Task<Result<void>> plan_anew(Goal goal, std::vector<std::string> objects);
  Task<Result<void>> adopt(Goal goal, std::vector<GroundOperation> plan);
  Task<Result<void>> do_operation(std::size_t index);
  // Whether the goal still held after the time to settle.
  Task<bool> settles(Goal goal);
  Task<void> tell_difference(std::vector<Datum> lost, std::string expected_by);
  Task<void> tell_unexpected(std::size_t expected, std::size_t next);
  Task<void> finish(Goal goal, Result<void> outcome);
  std::vector<std::string> objects_of(const Goal& goal) const;

  AgentContext& context_;
  const CoordinatorOptions& options_;
  const TaskDomain& domain_;
  Surroundings& surroundings_;
  Story& story_;
  Eyes& eyes_;
  Planning& planning_;
  TaskRunner& runner_;
  Vigil& vigil_;
  WaitList wanted_;

  std::optional<Goal> current_;
  std::int64_t last_number_ = 0;
  // The plan in use; none until one was made, or when no suffix of it holds.
  std::optional<TriangleTable> table_;
  std::int64_t planned_for_ = 0;  // the goal's number
};

}  // namespace pizarra
