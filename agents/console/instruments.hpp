#pragma once

// Measurements of a board, as JSON, that the program which serves the console hands in: its commands `top` and `method`
// know how to take them. Both use the page's own session, so its key decides what they may read.
//
//   Instruments instruments;
//   instruments.cells = [&](const std::string& key) { return cells_seen_with(key); };

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
  // Observes the board for `length`; the answer is that of `method --live --json`.
  std::function<Measured(Board& board, const std::string& name, Connect connect, Duration length)> method = nullptr;
  // How the cells do that this board names, and those that these name: {"cells": [...], "more": false}. Of each stands
  // there what `cells --json` prints; "more" says that there are others beyond a bound. They are asked with
  // the page's key; empty: the console's own.
  std::function<Measured(const std::string& key)> cells = nullptr;
};

}  // namespace pizarra::console
