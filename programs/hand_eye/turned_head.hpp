#pragma once

// The pan-tilt unit of a cell, turned by a client of the agent that has it.
//
//   TurnedHead head(executor, board, caller);
//   const Result<ptu::HeadTurn> turned = co_await head.turn_to({.pan_deg = 8, .tilt_deg = -2});
//
// Failures: no-head (no unit says what its limits are), still-turning, and the agent's.

#include "agents/runtime/caller.hpp"
#include "drivers/ptu/head_axes.hpp"
#include "drivers/ptu/pan_tilt_driver.hpp"

namespace pizarra::hand_eye {

class TurnedHead {
 public:
  // All outlive it.
  TurnedHead(Executor& executor, Board& board, runtime::Caller& caller)
      : executor_(executor), board_(board), caller_(caller) {}

  Task<Result<ptu::PanTiltRange>> range();
  // Once it stands: where that is, as the unit counts.
  Task<Result<ptu::HeadTurn>> turn_to(ptu::HeadTurn turn);

 private:
  Task<Result<Datum>> ask(Datum operation);

  Executor& executor_;
  Board& board_;
  runtime::Caller& caller_;
};

}  // namespace pizarra::hand_eye
