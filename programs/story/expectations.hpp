#pragma once

// The expectations of a scenario for its story: facts that must come, facts that must not, and the end.
//
//   Expectations expectations(scenario, board, executor);
//   expectations.begin();
//   ...
//   std::vector<std::string> unmet = expectations.unmet(report);   // one sentence each

#include <string>
#include <vector>

#include "blackboard/board.hpp"
#include "blackboard/time/executor.hpp"
#include "lisp/forms/scenario_file.hpp"
#include "programs/story/director_report.hpp"

namespace pizarra::story {

class Expectations {
 public:
  // All outlive it.
  Expectations(const forms::Scenario& scenario, Board& board, Executor& executor);
  void begin();
  std::vector<std::string> unmet(const DirectorReport& report) const;

 private:
  struct Expected {
    Datum pattern;
    bool wanted;  // must come, or must not
    bool came = false;
  };
  Task<void> watch_for(Expected& expected);

  const forms::Scenario& scenario_;
  Board& board_;
  Executor& executor_;
  std::vector<Expected> expected_;  // does not grow once begun
  std::vector<Job> jobs_;
};

}  // namespace pizarra::story
