#pragma once

// A loaded program at work: its rules follow the board and fire, its loops go round, its operations are answered.
//
// A rule fires once for each answer to its condition that comes to hold, one after another; an answer that ceases to
// hold and comes again fires again. A conclusion's facts stand while some answer holds them; where nobody has declared
// their relation yet, it is tried again until somebody has.
//
//   RunningProgram running(context, runner);      // begins at once
//   Result<Datum> answer = co_await RunningProgram::answer(runner, operation);
//
// Destroying it ends every run of rules and loops; what operations run goes on to its end.

#include <vector>

#include "agents/scheme/part_runner.hpp"

namespace pizarra::scheme {

class RunningProgram {
 public:
  RunningProgram(runtime::AgentContext& context, std::shared_ptr<PartRunner> runner);

  // The elements after `ok` of a reply.
  static Task<Result<Datum>> answer(std::shared_ptr<PartRunner> runner, Datum operation);

 private:
  // The facts that each answer's conclusions hold, by the ids of the facts that make up the answer.
  using Fired = std::map<std::vector<FactId>, std::vector<Datum>>;

  Task<void> follow_rule(const forms::ProgramPart& rule);
  Task<Result<void>> follow_watch(const forms::ProgramPart& rule, Watch& watch, Fired& fired);
  Task<Result<void>> fire(const forms::ProgramPart& rule, Answer answer, Fired& fired);
  Task<Result<void>> forget_gone(const Change& change, Fired& fired);
  Task<void> go_round(const forms::ProgramPart& loop);

  runtime::AgentContext& context_;
  std::shared_ptr<PartRunner> runner_;
  std::vector<Job> jobs_;
};

}  // namespace pizarra::scheme
