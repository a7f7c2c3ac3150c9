#pragma once

// The events that a scenario brings to a cell besides the goal: its `when`s, one after another, each when its facts
// come, and the actions before the goal.
//
//   StoryEvents events(cell, board, scenario, narrator, give_goal);
//   co_await events.perform(action);      // (hand ...) (fingers ...) (kill ...) (restart ...) (goal ...) (wait ...)
//   events.begin();
//   bool disturbed = co_await events.end(deadline);

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "agents/launcher/local_cell.hpp"
#include "lisp/forms/scenario_file.hpp"
#include "programs/story/narrator.hpp"

namespace pizarra::story {

class StoryEvents {
 public:
  using GiveGoal = std::function<Task<Result<void>>(std::vector<Datum> goal)>;

  // All outlive it.
  StoryEvents(launcher::LocalCell& cell, Board& board, const forms::Scenario& scenario, Narrator& narrator,
              GiveGoal give_goal)
      : cell_(cell), board_(board), scenario_(scenario), narrator_(narrator), give_goal_(std::move(give_goal)) {}

  void begin();
  // No event begins any more; one that has begun ends, or is broken off at the deadline. Whether there was one.
  Task<bool> end(Time deadline);
  Task<Result<void>> perform(Datum action);

  // How many came.
  std::size_t done() const { return done_; }
  // What the next one waits for; none: all have come.
  std::optional<Datum> awaited() const;
  // What went wrong, one sentence each.
  const std::vector<std::string>& troubles() const { return troubles_; }

 private:
  Task<void> happen();
  Task<void> happen_once(forms::ScenarioEvent event);
  Task<Result<void>> act(Datum action);
  Task<Result<void>> move_hand(Datum action);
  Task<Result<void>> ask_world(Datum action);

  launcher::LocalCell& cell_;
  Board& board_;
  const forms::Scenario& scenario_;
  Narrator& narrator_;
  GiveGoal give_goal_;
  std::size_t done_ = 0;
  bool acting_ = false;  // an action other than waiting is in hand
  std::vector<std::string> troubles_;
  Job job_;
};

}  // namespace pizarra::story
