#pragma once

// Looks at an arm that has no motion in hand: tells the board what changes by itself, and connects again after the
// controller was away. An arm that moves all the same (an order that came late, another's program) is stopped, and the
// board is told. An arm that somebody moves by the pendant is left alone.
//
//   RestWatch rest(executor, connection, control, facts, tell_period);
//   Job job = executor.spawn(rest.keep());            // for as long as the agent lives

#include "agents/robot/arm_control.hpp"

namespace pizarra::robot {

class RestWatch {
 public:
  static constexpr Duration reconnect_pause = 500ms;

  // All outlive it.
  RestWatch(Executor& executor, ArmConnection& arm, ArmControl& control, ArmFacts& facts, Duration tell_period);
  RestWatch(const RestWatch&) = delete;
  RestWatch& operator=(const RestWatch&) = delete;

  Task<void> keep();

 private:
  Task<void> look();
  Task<void> look_at_arm();

  Executor& executor_;
  ArmConnection& arm_;
  const ArmControl& control_;
  ArmFacts& facts_;
  const Duration tell_period_;
  WaitList look_now_;
};

}  // namespace pizarra::robot
