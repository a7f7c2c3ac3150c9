#pragma once

// The activity on a board between two samples, for `top`: who is there, what is told and how fast, what waits for whom,
// and how long a fact is under way.
//
//   BoardSampler sampler(executor, board, "top-17");
//   co_await sampler.begin();
//   co_await sleep(executor, 1s);
//   Result<BoardSample> sample = co_await sampler.next();       // since begin(), or since the last
//
// Tellers and watchers report themselves how long the facts of a relation are under way (statistics.hpp). Besides, the
// sampler times one fact of its own at each look, (board-probe WHO N SENT-US), which goes with the sampler. It times
// three spans: from the telling to the commit, to the board's answer, and to the arrival at a watcher. It tells one
// fact and no more, because every fact pushes older ones out of the journal. The commit is dated by the board's clock.
// That time is moved as little as possible to lie between telling and answer; on one machine it hardly moves. A sampler
// that may not tell the probe shows no journey.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "blackboard/board.hpp"
#include "blackboard/time/latch.hpp"

namespace pizarra::programs {

// In microseconds.
struct Spread {
  std::int64_t count = 0;
  std::int64_t p50_us = 0;
  std::int64_t p90_us = 0;
  std::int64_t p99_us = 0;
};

struct RelationSample {
  std::string name;
  std::int64_t facts = 0;
  double told_per_second = 0;
  std::int64_t watches = 0;
  std::vector<std::string> tellers;
  // How long its facts were under way lately, to the board and from there to watchers; count 0 where nobody said so.
  Spread told = {};
  Spread delivered = {};
};

// One probe: `committed` by the board's clock, the others by ours.
struct Probe {
  Time sent{};
  Time committed{};
  Time acknowledged{};
};
// How long after its telling it was committed.
Duration commit_time(const Probe& probe);

struct AgentSample {
  std::string name;
  std::string kind;
  std::string host;
  double told_per_second = 0;
  std::int64_t waiting = 0;  // requests that it has not taken
  std::int64_t queued = 0;   // changes of what it watches that it has not read
};

// Of all clients of one name in other processes; "" are those that said no hello.
struct ClientSample {
  std::string name;
  std::int64_t requests_per_second = 0;
  std::int64_t refused = 0;  // since the board began
  std::string newest_refusal = {};
};

// In microseconds.
struct Journey {
  double committed_us = 0;
  double acknowledged_us = 0;
  double delivered_us = 0;
};

struct BoardSample {
  Revision revision = 0;
  double transactions_per_second = 0;
  std::int64_t facts = 0;
  std::vector<AgentSample> agents;        // by name
  std::optional<Failure> agents_unknown;  // where clients declared them otherwise, or told too many for an answer
  std::vector<RelationSample> relations;  // the busiest first
  std::vector<ClientSample> clients;      // the busiest first
  std::optional<Journey> journey;
};

// One JSON object, as `top --json` prints it.
std::string json_of(const BoardSample& sample);

class BoardSampler {
 public:
  BoardSampler(Executor& executor, Board& board, std::string who)
      : executor_(executor), board_(board), who_(std::move(who)) {}
  Task<Result<void>> begin();
  Task<Result<BoardSample>> next();

 private:
  struct Counts {
    Time when{};
    Revision revision = 0;
    std::map<std::string, std::int64_t> told;                           // by relation
    std::map<std::pair<std::string, std::string>, std::int64_t> tells;  // by relation and teller
  };

  Task<Result<std::vector<Fact>>> ask_about(Datum pattern);
  Task<Result<std::vector<Fact>>> statistics();
  Task<void> add_journeys(BoardSample& sample);
  Task<void> add_queues(BoardSample& sample);
  Task<void> add_clients(BoardSample& sample);
  static Result<void> go_without(BoardSample& sample, const Failure& failure);
  Task<Result<void>> add_agents(BoardSample& sample, const Counts& now);
  Task<Result<Journey>> travel();
  Counts count(const std::vector<Fact>& statistics, Revision revision) const;
  double rate(std::int64_t more, const Counts& now) const;
  std::int64_t told_since(const std::string& relation, const Counts& now) const;
  double rate_of(const std::string& teller, const Counts& now) const;

  Executor& executor_;
  Board& board_;
  const std::string who_;
  Revision revision_ = 0;
  int looks_ = 0;
  Counts before_;
};

}  // namespace pizarra::programs
