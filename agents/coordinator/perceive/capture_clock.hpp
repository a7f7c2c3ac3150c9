#pragma once

// When frames were captured, on the board's clock. The eyes stamp them by a clock of their own, and their looks are a
// while on the way to the board, some of them for seconds. The one that was fastest lately says how the clocks differ.
//
//   CaptureClock clock;
//   std::optional<Time> then = clock.on_board(captured, look.when);     // none before some looks came

#include <deque>
#include <optional>

#include "blackboard/time/clock.hpp"

namespace pizarra::coordinator {

class CaptureClock {
 public:
  // `captured` by the eyes' clock, of a frame of which the board was told at `told`, by its own. Too late by what the
  // fastest of the last looks took, never by what this one took.
  std::optional<Time> on_board(Time captured, Time told);

 private:
  std::deque<Duration> differences_;
};

}  // namespace pizarra::coordinator
