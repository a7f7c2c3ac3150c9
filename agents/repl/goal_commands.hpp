#pragma once

// The commands about goals: goal, cancel, plan and why.
//
//   GoalCommands goals(prompt, Patience::ended);
//   Evaluation outcome = co_await goals.goal(typed);       // (goal (on circle triangle))

#include "agents/repl/prompt.hpp"

namespace pizarra::repl {

// Whether `(goal ...)` answers when the goal was accepted or when it has ended.
enum class Patience : std::uint8_t { accepted, ended };

class GoalCommands {
 public:
  // The prompt outlives it.
  GoalCommands(Prompt& prompt, Patience patience) : prompt_(prompt), patience_(patience) {}

  Task<Evaluation> goal(Typed typed);
  Task<Evaluation> cancel(Typed typed);
  Task<Evaluation> plan(Typed typed);
  Task<Evaluation> why(Typed typed);

 private:
  Task<Evaluation> wait_for_end(Datum number, std::string typed);
  void say_end(const Datum& state, const std::string& typed);
  Task<bool> being_taught();
  Task<Evaluation> why_fact(Datum pattern);

  Prompt& prompt_;
  Patience patience_;
};

}  // namespace pizarra::repl
