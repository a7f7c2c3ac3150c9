#pragma once

// EVENT: the server starts, and tells one client something that the client deals with when it likes.
//
//   (notice ID CLIENT FORM)      until the client takes it, under the server's presence
//
//   Notifier notifier(context, service);
//   co_await notifier.notify("coordinator", list("limit-reached"_sym, "axis-1"_sym));
//   Result<Datum> event = co_await next_event(context, deadline);      // in the client: each once, in order
//
// A client that is away, or comes again under its name, finds what was meant for it.

#include "agents/runtime/service.hpp"

namespace pizarra::runtime {

Relation notice_relation();

class Notifier {
 public:
  Notifier(AgentContext& context, const Service& service) : context_(context), service_(service) {}
  Task<Result<void>> notify(std::string client, Datum form);

 private:
  AgentContext& context_;
  const Service& service_;
  std::uint64_t count_ = 0;
};

// The next for this agent. Failure timeout.
Task<Result<Datum>> next_event(AgentContext& context, Time deadline);

}  // namespace pizarra::runtime
