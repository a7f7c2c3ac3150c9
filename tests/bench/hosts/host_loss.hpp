#pragma once

// A cell whose boards take over from each other, on three hosts, and what is lost when the host of the board that leads
// loses its power while a goal is pursued.
//
//   HostLoss cell(seed, is_stopped);            // throws where it cannot be had
//   for (int round = 0; round < 20; ++round) cell.round();
//   cell.tally()

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>
#include <zmq.hpp>

#include "blackboard/client/remote_board.hpp"
#include "blackboard/time/random.hpp"
#include "blackboard/time/real_executor.hpp"
#include "drivers/simulation/socket_link.hpp"
#include "programs/story/world_state.hpp"
#include "tests/bench/hosts/goal_end.hpp"
#include "tests/network/cell_on_hosts.hpp"
#include "tests/programs/running.hpp"

namespace pizarra::bench {

class HostLoss {
 public:
  struct Tally {
    int rounds = 0;
    int reached = 0;            // and the world shows it
    int refused_correctly = 0;  // and in the world a cube of the goal is gone, or its pursuer's host is
    int failed = 0;
    int durable_lost = 0;  // acknowledged facts that are missing, and retracted ones that stand
    int done_twice = 0;    // an operation that was done, and done again with no other one begun between
    bool is_well() const { return failed + durable_lost + done_twice == 0; }
  };

  // In seconds from the loss of a host, one of each round: the first note that was sent after it and acknowledged, and
  // the first news of an operation, in rounds whose goal was not reached by then.
  struct Waits {
    std::vector<double> told_s;
    std::vector<double> worked_s;
  };

  // A round throws when it is stopped.
  HostLoss(std::uint64_t seed, std::function<bool()> is_stopped);
  HostLoss(const HostLoss&) = delete;
  HostLoss& operator=(const HostLoss&) = delete;
  ~HostLoss();
  void round();
  const Tally& tally() const { return tally_; }
  const Waits& waits() const { return waits_; }
  // Of the last round: the host that was lost, and how it ended; where it did not end well, what the cell says of it.
  const std::string& last() const { return last_; }

 private:
  void begin();
  Task<void> tell_notes();
  Task<void> watch_operations();
  void pass(Duration time);
  void wait_for_the_coordinator();
  // Whether the goal had ended by then.
  bool lose_the_leading_host(programs::Running& asking);
  void note_wait(std::optional<Time>& since, std::vector<double>& waits_s) const;
  void judge(const std::string& upper, GoalEnd end);
  int lost_notes();
  // The coordinator's newest events, a line each.
  std::string newest_events();
  story::WorldState truth();
  Duration between(int least_ms, int most_ms);

  const std::function<bool()> is_stopped_;
  Random random_;
  network::CellOnHosts cell_;
  RealExecutor executor_;
  zmq::context_t context_;
  std::unique_ptr<client::RemoteBoard> board_;
  std::unique_ptr<simulation::SocketLink> world_;
  Tally tally_;
  Waits waits_;
  // When the host was lost, until it was waited for.
  std::optional<Time> no_tell_since_;
  std::optional<Time> no_work_since_;
  std::string last_;
  std::int64_t next_note_ = 1;
  std::int64_t first_note_ = 1;          // of this round
  std::set<std::int64_t> acknowledged_;  // notes of this round
  bool tells_ = false;
  bool is_telling_ = false;
  Datum done_last_;
  std::optional<FactId> seen_last_;
  std::optional<Job> telling_;
  std::optional<Job> watching_;
};

}  // namespace pizarra::bench
