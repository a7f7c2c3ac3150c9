#pragma once

// What the program that serves the console can measure of a board, as JSON: its commands `top` and `method` know how,
// and hand it in. Both work with the page's own session, as its key may.

#include <functional>
#include <memory>
#include <string>

#include "blackboard/board.hpp"
#include "blackboard/time/task.hpp"

namespace pizarra::console {

struct Instruments {
  using Measured = Task<Result<std::string>>;
  // Another client of the same board with the same rights.
  using Connect = std::function<Result<std::unique_ptr<Board>>(const std::string& name)>;

  // The board's traffic since the call before, as `top --json` prints it; the first time since it was made.
  std::function<std::function<Measured()>(Board& board, const std::string& name)> activity = nullptr;
  // Looks for so long, as `method --live --json`.
  std::function<Measured(Board& board, const std::string& name, Connect connect, Duration length)> method = nullptr;
};

}  // namespace pizarra::console
