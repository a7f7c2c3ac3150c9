#pragma once

// The witness looks at the simulated world while a story is played, and says in the end what is so: nothing of it
// reaches an agent.
//
//   Witness witness(cell, judge);
//   witness.open_eyes();                                        // once the objects have been learned
//   bool blind = witness.blind_to(goal);
//   Result<Verdict> verdict = co_await witness.judge(goal);

#include <map>
#include <string>
#include <vector>

#include "agents/launcher/local_cell.hpp"
#include "programs/story/judge.hpp"

namespace pizarra::story {

struct Verdict {
  bool holds = false;
  bool possible = true;  // where it does not hold: whether any plan exists from the true state
};

class Witness {
 public:
  // All outlive it.
  Witness(launcher::LocalCell& cell, const Judge& judge) : cell_(cell), judge_(judge) {}
  void open_eyes();
  // Whether a cube of the goal was less than half visible for the last 2 s.
  bool blind_to(const std::vector<Datum>& goal) const;
  // Whether the world shows this now, as Judge::shows() does. Failures as judge().
  Task<Result<bool>> shows(std::vector<Datum> goal) const;
  // Waits until what was built stands still, or falls. Failures: the link's, the domain's rules'.
  Task<Result<Verdict>> judge(std::vector<Datum> goal);

 private:
  Task<void> keep_eyes_open();

  launcher::LocalCell& cell_;
  const Judge& judge_;
  std::map<std::string, Time> last_visible_;
  Job eyes_;
};

}  // namespace pizarra::story
