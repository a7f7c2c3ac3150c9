#pragma once

// What the clients of the ordeal share: how they come to the board, and how they report.

#include <memory>
#include <string>

#include "blackboard/client/remote_board.hpp"
#include "tests/bench/crash/clients.hpp"

namespace pizarra::bench {

void report(int reports, const Report& what);
// Tries again until the board has declared it.
Task<void> declare(Board& board);
std::unique_ptr<client::RemoteBoard> connect(Executor& executor, const std::string& address, const std::string& kind,
                                             int who);

}  // namespace pizarra::bench
