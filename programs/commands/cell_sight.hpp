#pragma once

// How the cells of a hall do, each by its own board: the boards that a board names, and of each who is there, its
// newest goal, its arms and what stops them.
//
//   for (const CellSight& cell : look_at_cells(executor, contexts, "tcp://hall:7943", reach)) ...

#include <functional>

#include "blackboard/client/contexts.hpp"

namespace pizarra::programs {

struct CellSight {
  std::string path;  // empty for the board that was begun with
  std::string address;
  std::optional<Failure> fault = {};  // why it is not known how this one does
  std::size_t agents = 0;
  std::string goal = {};   // `3 running (on circle triangle)`
  std::string arms = {};   // `robot moving`; of a fault and a stop, why
  std::string stops = {};  // `hall: lunch`
};

using Reach = std::function<Result<std::unique_ptr<client::RemoteBoard>>(const std::string& address)>;

// Boards that do not answer are waited for together.
std::vector<CellSight> look_at_cells(Executor& executor, client::Contexts& contexts, const std::string& root,
                                     const Reach& reach);

}  // namespace pizarra::programs
