#pragma once

// Pursues the goal: the thesis' steps a to h, one goal at a time, until it holds or cannot.
//
// Its rounds: the planner, which owns the plan, is told what is believed and hands out the operation to do next. No end
// of the plan serves: a new plan. Nothing is left to do: watch for a while that the goal stays. A belief that holds no
// more is told as a difference, with the frame that showed it. So is the consequence: which part of the plan in hand
// still serves, or the new plan. The goal is a durable fact, from which a new life of the coordinator goes on; the plan
// is the planner's.
//
// A wish changes on the board first: a goal that the board refuses, as one whose disk is full does, changes
// nothing here.

#include <map>
#include <set>

#include "agents/coordinator/act/camera_survey.hpp"
#include "agents/coordinator/act/rescues.hpp"
#include "agents/coordinator/act/task_runner.hpp"
#include "agents/coordinator/pursue/hold_up.hpp"
#include "agents/coordinator/pursue/planning.hpp"
#include "agents/coordinator/pursue/wish.hpp"
#include "blackboard/time/turns.hpp"

namespace pizarra::coordinator {

class Pursuit {
 public:
  Pursuit(runtime::AgentContext& context, const CoordinatorOptions& options, const TaskDomain& domain,
          Surroundings& surroundings, Story& story, Eyes& eyes, Planning& planning, TaskRunner& runner,
          Rescues& rescues, CameraSurvey& survey, Vigil& vigil)
      : context_(context),
        options_(options),
        domain_(domain),
        surroundings_(surroundings),
        story_(story),
        eyes_(eyes),
        planning_(planning),
        runner_(runner),
        rescues_(rescues),
        survey_(survey),
        vigil_(vigil),
        hold_up_(context, story, vigil),
        turns_(context.executor),
        wanted_(context.executor) {}

  // Takes up the goal and the plan that stand on the board, before anything else.
  Task<void> resume();
  // Goes on for ever, one goal after another.
  Task<void> run();
  // Takes a checked goal, instead of the one in hand, and answers its number. Failures: the board's.
  Task<Result<std::int64_t>> submit(std::vector<Datum> facts);
  // Gives up the goal in hand. Failures: no-goal, and the board's.
  Task<Result<void>> cancel();

 private:
  struct Goal {
    std::int64_t number;
    std::vector<Datum> facts;  // as it stands on the board; while a stage is pursued, what that wants
    std::size_t stage = 0;     // of its wish, to begin with
  };

  // How far the rounds of one goal have come.
  struct Progress {
    std::optional<NextOperation> expected;  // what is handed out next unless something differs
    std::optional<std::size_t> announced;   // the one that the story has said to be next
    std::map<Datum, int> failures_of;
    int failures = 0;
    int plans = 0;
  };

  // In search of one object: `done` once it was moved, or could not be moved however often that was tried.
  struct SetAside {
    std::set<std::string> done;
    std::map<std::string, int> failed;
  };

  // All of its stages, and for ever where it is to be kept.
  Task<Result<void>> pursue(Goal goal);
  Task<Result<void>> pursue_stages(Goal goal, Wish wish);
  // Waits for what is missing, as often as something is, as long as its patience lasts each time.
  Task<Result<void>> pursue_patiently(Goal goal, Duration patience);
  Task<Result<void>> await_missing(std::int64_t goal, Failure missing, Duration patience);
  Task<Result<void>> keep(Goal goal, Wish wish);
  // Until something believed changes, or a while.
  Task<void> await_change();
  Task<void> tell_progress(std::int64_t goal, std::string_view state, Datum detail, std::string_view kind,
                           std::string sentence);
  Task<Result<void>> pursue_once(Goal goal);
  // Until it holds, cannot, or something holds the cell up.
  Task<Result<void>> attempt(Goal goal);
  Task<Result<void>> rounds(Goal goal);
  // Where it is not known well enough, or no more, where the camera stands.
  Task<Result<void>> find_camera();
  // The first plan, whatever comes of it.
  Task<Result<void>> carry_out_blindly(Goal goal);
  // The operation to go on with; none where a plan had to be made first.
  Task<Result<std::optional<NextOperation>>> choose(Goal goal, Progress& progress);
  // The same of the plan in hand; none where it does not serve.
  Task<Result<std::optional<NextOperation>>> hand_out(std::int64_t goal);
  // Takes note of a failed operation; a failure where it is to be the last.
  Task<Result<void>> recover(GroundOperation operation, Failure why, Progress& progress);
  // Changes the scene where trying the same again would end the same way.
  Task<void> try_otherwise(GroundOperation operation, Failure why);
  Task<Result<void>> look_for(std::vector<std::string> objects);
  bool stands_low() const;
  Task<Result<void>> look_once_for(std::string object, Time deadline);
  // Whether it was tried to set something aside that may hide the missing object. The second time that the same thing
  // hides it, what that stood on goes too: there the plan would put it again.
  Task<Result<bool>> clear_view(std::string missing, SetAside& set_aside);
  Task<void> await_steady(std::vector<std::string> objects);
  // Whether a new plan was made: false where the one in hand serves again.
  Task<Result<bool>> plan_anew(Goal goal, std::vector<std::string> objects);
  Task<void> tell_plan(std::int64_t goal, std::vector<Datum> operations);
  Task<Result<void>> do_operation(NextOperation next);
  // Whether the goal still held after the time to settle.
  Task<bool> settles(Goal goal);
  Task<void> tell_difference(std::vector<Datum> lost, std::string expected_by);
  Task<void> tell_unexpected(NextOperation expected, std::size_t next);
  Task<void> tell_still_serves(std::int64_t goal, NextOperation next);
  Task<void> finish(Goal goal, Result<void> outcome);
  // False where the board has no room for it.
  Task<bool> end(Goal goal, Result<void> outcome);
  Task<Result<Revision>> tell_outcome(std::int64_t number, std::string_view state, Datum detail);
  std::vector<std::string> objects_of(const Goal& goal) const { return domain_.objects_in(goal.facts); }

  runtime::AgentContext& context_;
  const CoordinatorOptions& options_;
  const TaskDomain& domain_;
  Surroundings& surroundings_;
  Story& story_;
  Eyes& eyes_;
  Planning& planning_;
  TaskRunner& runner_;
  Rescues& rescues_;
  CameraSurvey& survey_;
  Vigil& vigil_;
  HoldUp hold_up_;
  Turns turns_;  // to change what is wanted
  WaitList wanted_;

  std::optional<Goal> current_;
  std::int64_t last_number_ = 0;
  int set_aside_ = 0;  // how often something was, in search of what the goal in hand names
  std::set<std::pair<std::string, std::string>> hid_;  // a missing object, and what was set aside before it
  std::int64_t planned_for_ = 0;                       // the number of the goal for which the planner may have a plan
};

}  // namespace pizarra::coordinator
