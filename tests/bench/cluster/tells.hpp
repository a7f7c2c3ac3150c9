#pragma once

// Durable tells to the leading board of a cluster, so many in flight.
//
//   const auto board = board_for_tells(executor, cell);
//   const TellTimes all = tells(executor, *board, in_flight, 4000);

#include <chrono>
#include <memory>
#include <vector>

#include "blackboard/client/remote_board.hpp"
#include "blackboard/time/real_executor.hpp"
#include "tests/bench/cluster/cluster_cell.hpp"

namespace pizarra::bench {

inline constexpr int in_flight = 64;

struct TellTimes {
  std::vector<double> ms;
  double per_s = 0;
};

double ms_since(std::chrono::steady_clock::time_point begun);

// Which leads, and has been told some facts.
std::unique_ptr<client::RemoteBoard> board_for_tells(RealExecutor& executor, const ClusterCell& cell);
TellTimes tells(RealExecutor& executor, client::RemoteBoard& board, int at_once, int all);

}  // namespace pizarra::bench
