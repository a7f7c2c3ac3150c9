#pragma once

// How the cells of a hall do, each by its own board: the boards that a board names, and of each who is there, its
// newest goal, its arms, what stops them, whose board leads and what happened last.
//
//   std::vector<CellSight> cells = co_await look_at_cells(executor, contexts, "tcp://hall:7943");

#include "blackboard/client/contexts.hpp"

namespace pizarra::programs {

struct CellSight {
  std::string path;  // empty for the board that was begun with
  std::string address;
  std::optional<Failure> fault = {};  // why it is not known how this one does
  std::size_t agents = 0;
  std::string goal = {};     // `3 running (on circle triangle)`
  std::string arms = {};     // `robot moving`; of a fault and a stop, why
  std::string stops = {};    // `hall: lunch`
  std::string leads = {};    // of boards that take over from each other
  std::string said = {};     // the newest event's sentence
  std::string console = {};  // the address of one that other machines reach
};

// As one JSON object. Of a longer text the beginning stands there.
std::string json_of(const CellSight& cell, std::size_t longest_text = std::string::npos);

// The board at `root` first, and `most` boards at most. Those that do not answer are waited for together, and none for
// long. Executor and contexts outlive the look.
Task<std::vector<CellSight>> look_at_cells(Executor& executor, client::Contexts& contexts, std::string root,
                                           std::size_t most = client::Contexts::most_listed);

}  // namespace pizarra::programs
