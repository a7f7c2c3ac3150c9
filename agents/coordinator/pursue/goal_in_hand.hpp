#pragma once

// The goal that is wanted, as durable facts: given, replaced, cancelled, ended, and taken up again after a restart.
//
//   GoalInHand goal(context, story, interruption);
//   co_await goal.resume();                                  // what stands on the board
//   Result<std::int64_t> number = co_await goal.submit(facts);
//   const Goal wanted = co_await goal.next();                // as soon as anything is wanted
//   co_await goal.finish(wanted, outcome);                   // unless another one is wanted by then
//
// A goal changes on the board first: one that the board refuses, as it does when its disk is full, changes
// nothing here.

#include <optional>
#include <string>
#include <vector>

#include "agents/coordinator/plan/interruption.hpp"
#include "agents/coordinator/story.hpp"
#include "agents/runtime/agent.hpp"
#include "blackboard/time/latch.hpp"
#include "blackboard/time/turns.hpp"

namespace pizarra::coordinator {

struct Goal {
  std::int64_t number;
  std::vector<Datum> facts;  // as it stands on the board; while a stage is pursued, what that wants
  std::size_t stage = 0;     // of its stages, to begin with
};

class GoalInHand {
 public:
  GoalInHand(runtime::AgentContext& context, Story& story, Interruption& interruption)
      : context_(context),
        story_(story),
        interruption_(interruption),
        turns_(context.executor),
        wanted_(context.executor) {}

  // Takes up the goal that stands on the board, before anything else.
  Task<void> resume();
  // Takes a checked goal, instead of the one in hand, and answers its number. Failures: the board's.
  Task<Result<std::int64_t>> submit(std::vector<Datum> facts);
  // Gives up the goal in hand. Failures: no-goal, and the board's.
  Task<Result<void>> cancel();

  const std::optional<Goal>& current() const { return current_; }
  // The goal in hand, as soon as there is one.
  Task<Goal> next();
  // How far it has come; says nothing of a goal that is wanted no more.
  Task<void> tell_progress(std::int64_t goal, std::string_view state, Datum detail, std::string_view kind,
                           std::string sentence);
  // It stays in hand until its end could be told.
  Task<void> finish(Goal goal, Result<void> outcome);

 private:
  bool is_wanted(std::int64_t goal) const { return current_ && current_->number == goal; }
  // False where the board has no room for it.
  Task<bool> end(Goal goal, Result<void> outcome);
  Task<Result<Revision>> tell_outcome(std::int64_t number, std::string_view state, Datum detail);

  runtime::AgentContext& context_;
  Story& story_;
  Interruption& interruption_;
  Turns turns_;  // to change what is wanted
  WaitList wanted_;
  std::optional<Goal> current_;
  std::int64_t last_number_ = 0;
};

}  // namespace pizarra::coordinator
