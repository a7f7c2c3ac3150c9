#pragma once

// How an agent is there: it has declared what it posts, and holds its name by a lease that it renews. With the lease go
// its name, its contract and whatever else it tells under it. An agent that offers anything is bound by its name
// (own_name.hpp), where its key lets it.
//
//   Presence presence(context, contract);
//   Result<void> started = co_await presence.start();
//   transaction.tell(fact, {}, presence.lease());
//   co_await presence.end();                               // frees the name at once
//
// Where the board forgot the lease, because it restarted or was away for too long, the agent announces itself under a
// new one as soon as the name is free. Destroying it leaves the lease to lapse. What it is given outlives it.

#include "agents/runtime/agent.hpp"
#include "agents/runtime/contract.hpp"
#include "blackboard/time/latch.hpp"

namespace pizarra::runtime {

class Presence {
 public:
  static constexpr Duration lease_length = 2s;
  static constexpr Duration renewal = 500ms;

  Presence(AgentContext& context, const Contract& contract)
      : context_(context), contract_(contract), announced_(context.executor) {}

  // Declares the runtime's and the contract's relations, waits until the name is free, tells presence and contract.
  Task<Result<void>> start();
  Task<Result<void>> end();
  // 0 before it has started.
  LeaseId lease() const { return lease_; }
  // Until it stands under another lease than that.
  Task<void> until_replaced(LeaseId lease);

 private:
  Task<Result<void>> declare();
  Transaction facts(LeaseId lease) const;
  Task<Result<void>> announce();
  Task<void> keep();
  Task<void> bind_own_name();

  AgentContext& context_;
  const Contract& contract_;
  LeaseId lease_ = 0;
  bool names_declared_ = false;
  bool may_bind_ = true;
  WaitList announced_;
  Job keeping_;
};

}  // namespace pizarra::runtime
