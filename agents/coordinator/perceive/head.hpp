#pragma once

// Whoever plays the head that the cameras stand on, as the coordinator uses it. A cell whose cameras stand still has
// none.
//
//   const Result<HeadRange> range = co_await head.free_range();      // it may be turned, so far
//   const Result<void> turned = co_await head.turn({.pan_deg = 20, .tilt_deg = 0});     // it stands there
//
// Failures: head-away (no unit, or nobody knows where it stands), head-taken (somebody's `look-at` keeps an object in
// view), halted (a stop stands), and those of the pan-tilt agent. Every wait has an end.

#include "agents/coordinator/geometry/head_views.hpp"
#include "agents/coordinator/perceive/surroundings.hpp"
#include "agents/runtime/roles.hpp"

namespace pizarra::coordinator {

// A pan-tilt unit's agent.
runtime::Role head_role();

class Head {
 public:
  // All outlive it.
  Head(runtime::AgentContext& context, const CoordinatorOptions& options, runtime::Roles& roles,
       runtime::Caller& caller, Surroundings& surroundings)
      : context_(context), options_(options), roles_(roles), caller_(caller), surroundings_(surroundings) {}

  bool is_there() const { return options_.head; }
  Task<Result<HeadRange>> free_range();
  Task<Result<void>> turn(HeadTurn turn);

 private:
  Task<Result<void>> may_turn();
  Task<bool> stands_at(HeadTurn turn);

  runtime::AgentContext& context_;
  const CoordinatorOptions& options_;
  runtime::Roles& roles_;
  runtime::Caller& caller_;
  Surroundings& surroundings_;
};

}  // namespace pizarra::coordinator
