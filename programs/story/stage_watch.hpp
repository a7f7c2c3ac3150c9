#pragma once

// Has the world judge each stage of a goal but the last, when the coordinator tells that it goes on to the next one:
// the world is asked at once, before the next stage changes it. Each judgement is told.
//
//   StageWatch stages(context, witness, narrator);
//   stages.begin(1, goal);                       // and again for each goal that takes its place
//   stages.unmet("reached");                   // {"the cell said that stage 1 of 2, (on a b), holds, ..."}

#include <optional>
#include <string>
#include <vector>

#include "agents/runtime/agent.hpp"
#include "programs/story/narrator.hpp"
#include "programs/story/witness.hpp"

namespace pizarra::story {

class StageWatch {
 public:
  // All outlive it.
  StageWatch(runtime::AgentContext& context, const Witness& witness, Narrator& narrator)
      : context_(context), witness_(witness), narrator_(narrator) {}

  // Of the goal with that number.
  void begin(std::int64_t goal, const std::vector<Datum>& forms);
  // The stages that the world did not show, one sentence each. Where the goal was reached, also those of which the
  // cell never said that they hold.
  std::vector<std::string> unmet(std::string_view outcome) const;

 private:
  Task<void> take(Change change);
  Task<void> judge(std::size_t stage);

  runtime::AgentContext& context_;
  const Witness& witness_;
  Narrator& narrator_;
  std::vector<std::vector<Datum>> stages_;
  std::vector<std::optional<bool>> shown_;  // of each stage but the last; none: the cell has not said that it holds
  Job job_;
};

// What the goal wants in the end, in words; of several stages "stage 2 of 2: (in square second)".
std::string words_of_the_end(const std::vector<Datum>& goal);

}  // namespace pizarra::story
