#pragma once

// How long clients wait when whoever leads is killed: for the first tell that is acknowledged, for the first ask that
// is answered, and until an agent that was there is there again.
//
//   Takeovers takeovers(executor, cell);
//   const Waits waits = takeovers.of([&] { cell.kill_board(cell.await_leading_board()); }, 100);

#include <functional>
#include <vector>

#include "agents/runtime/service.hpp"
#include "blackboard/client/remote_board.hpp"
#include "blackboard/time/real_executor.hpp"
#include "tests/bench/cluster/cluster_cell.hpp"

namespace pizarra::bench {

struct Waits {
  std::vector<double> tell_s;
  std::vector<double> ask_s;
  std::vector<double> present_s;
  int lost = 0;  // facts that were acknowledged and are not there
};

class Takeovers {
 public:
  Takeovers(RealExecutor& executor, ClusterCell& cell);
  Waits of(const std::function<void()>& kill, int rounds);

 private:
  Task<void> until_told(Time begun, double* took);
  Task<void> until_asked(Time begun, double* took);
  Task<void> until_present(Time begun, double* took);
  // Both boards and all members are there, and one leads.
  void wait_until_whole();

  RealExecutor& executor_;
  ClusterCell& cell_;
  std::unique_ptr<client::RemoteBoard> teller_;
  std::unique_ptr<client::RemoteBoard> asker_;
  std::unique_ptr<client::RemoteBoard> looker_;
  std::unique_ptr<client::RemoteBoard> agents_;
  runtime::AgentContext agent_;
  runtime::Service service_;  // of an agent that does nothing
  std::int64_t told_ = 0;
  std::vector<std::int64_t> acknowledged_;
};

}  // namespace pizarra::bench
