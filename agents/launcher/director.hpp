#pragma once

// The director lets a scenario happen in a cell: waits until the person has taught the objects, gives the goal, does
// what the scenario's `when`s ask for when their facts come, and in the end has the world judged.
//
//   Director director(cell, scenario, judge, narrator);
//   Job job = executor.spawn(director.run());
//   executor.run_until([&] { return job.done(); });
//   director.report().met();

#include <functional>
#include <map>
#include <optional>

#include "agents/launcher/judge.hpp"
#include "agents/launcher/local_cell.hpp"
#include "agents/launcher/narrator.hpp"
#include "agents/launcher/truth.hpp"
#include "agents/runtime/service.hpp"
#include "lisp/scenario.hpp"

namespace pizarra {

struct DirectorReport {
  // How the cell saw it: reached, refused, cancelled, or malformed, timeout, not-taught, no-agents.
  std::string outcome;
  std::optional<Failure> refusal;  // for refused and malformed
  bool refusal_told = false;       // whether the coordinator told it as an event of the story
  std::vector<Datum> goal;         // the last one
  bool truth_holds = false;        // the judge's word on that goal
  bool possible = true;            // where it does not hold: whether any plan exists from the true state
  bool blind = false;              // a goal cube's mark was less than half visible for the last 2 s
  std::vector<std::string> unmet;  // expectations, one sentence each
  std::size_t events = 0;          // how many of the scenario's came
  Duration took{};                 // from the goal to its end, the cell's time

  // Reached and so in the world.
  bool reached() const { return outcome == "reached" && truth_holds; }
  // Refused for a reason that lies in the goal or the world, and the world bears it out: there is truly no plan, or a
  // cube of the goal could not be seen.
  bool refused_correctly() const;
};

struct DirectorOptions {
  // Where true, a `when` whose facts never come is not an expectation that was missed: it is dropped when the goal has
  // ended. When the end finds the hand at work, the goal is given again, as a person would.
  bool events_may_fail = false;
  // Gives the goal in place of the scenario's, once it is known which objects have been learned.
  std::function<Result<std::vector<Datum>>(const std::vector<std::string>& objects)> read_goal = {};
};

class Director {
 public:
  // All but the options outlive it.
  Director(LocalCell& cell, const Scenario& scenario, const Judge& judge, Narrator& narrator,
           DirectorOptions options = {});
  ~Director();
  Task<void> run();
  const DirectorReport& report() const { return report_; }

 private:
  Task<Result<void>> prepare();
  Task<Result<void>> begin_goal();
  Task<Result<void>> give_goal(std::vector<Datum> goal);
  Task<void> await_end(Time deadline);
  Task<Result<void>> await_agents();
  Task<Result<void>> await_teaching();
  Task<void> story();
  Task<void> happen();
  Task<void> happen_once(ScenarioEvent event);
  Task<Result<void>> perform(Datum action);
  Task<Result<void>> act(Datum action);
  Task<Result<void>> end_events(Time last);
  Task<Result<void>> move_hand(Datum action);
  Task<void> watch_for(Datum pattern, char* seen);
  Task<void> keep_eyes_open();
  Task<void> give_judgement();
  Task<Result<void>> look_at_world();
  void check_expectations();

  LocalCell& cell_;
  const Scenario& scenario_;
  const Judge& judge_;
  Narrator& narrator_;
  DirectorOptions options_;
  std::unique_ptr<Board> board_;
  AgentContext context_;
  Service service_;
  Caller caller_;
  DirectorReport report_;
  std::int64_t goal_number_ = 0;
  std::size_t events_done_ = 0;
  std::vector<char> seen_;  // expect_seen, then expect_never: whether it came
  std::vector<Job> jobs_;
  Job events_;
  bool acting_ = false;  // an action other than waiting is in hand
  std::map<std::string, Time> last_visible_;
};

}  // namespace pizarra
