#pragma once

// The director lets a scenario happen in a cell: waits until the person has taught the objects, gives the goal, does
// what the scenario's `when`s ask for when their facts come, and in the end has the world judged.
//
//   Director director(cell, scenario, judge, narrator);
//   Job job = executor.spawn(director.run());
//   executor.run_until([&] { return job.done(); });
//   director.report().met();

#include "agents/runtime/caller.hpp"
#include "programs/story/director_report.hpp"
#include "programs/story/expectations.hpp"
#include "programs/story/narrator.hpp"
#include "programs/story/stage_watch.hpp"
#include "programs/story/story_events.hpp"

namespace pizarra::story {

struct DirectorOptions {
  // Where true, a `when` whose facts never come is not an expectation that was missed: it is dropped when the goal has
  // ended. When the end finds the hand at work, the goal is given again, as a person would.
  bool events_may_fail = false;
};

class Director {
 public:
  // All but the options outlive it.
  Director(launcher::LocalCell& cell, const forms::Scenario& scenario, const Judge& judge, Narrator& narrator,
           DirectorOptions options = {});
  ~Director();
  Task<void> run();
  const DirectorReport& report() const { return report_; }

 private:
  Task<void> story();
  Task<Result<void>> prepare();
  Task<Result<void>> give_goal(std::vector<Datum> goal);
  Task<void> await_end(Time deadline);
  Task<Result<void>> await_events(Time deadline);
  Task<Result<bool>> is_kept(std::int64_t number);
  Task<void> give_judgement();

  launcher::LocalCell& cell_;
  const forms::Scenario& scenario_;
  DirectorOptions options_;
  std::unique_ptr<Board> board_;
  runtime::AgentContext context_;
  runtime::Service service_;
  runtime::Caller caller_;
  DirectorReport report_;
  std::int64_t goal_number_ = 0;
  Expectations expectations_;
  StoryEvents events_;
  Witness witness_;
  StageWatch stages_;
};

}  // namespace pizarra::story
