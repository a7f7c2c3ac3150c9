#pragma once

// How a board's program ends, and what it says then.

#include <fmt/format.h>

#include "lisp/result.hpp"

namespace pizarra::programs {

enum BoardExit : int { stopped = 0, bad_usage = 2, bad_address = 3, bad_journal = 4 };

inline int complain(const Failure& failure, BoardExit code) {
  fmt::print(stderr, "pizarra-board: {}\n", describe(failure));
  return code;
}

}  // namespace pizarra::programs
