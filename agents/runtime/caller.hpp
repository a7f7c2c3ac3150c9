#pragma once

// Asks another agent for something and waits for the reply's `ok` elements as a list.
//
//   Caller caller(context, service);
//   Result<Datum> answer = co_await caller.call("vision", operation, 10s);
//
// Failures: those of the agent, and `timeout` (the request is then withdrawn). Request ids are NAME-PRESENCE-COUNT,
// unique on one board. Who asks is present: a request goes when the presence of its caller lapses. A program that
// offers nothing has a Service with an empty contract.

#include <functional>
#include <string>

#include "agents/runtime/service.hpp"

namespace pizarra::runtime {

// Who is asked: an agent by its name, or whoever plays a role (roles.hpp).
struct Callee {
  Callee(std::string name, std::function<bool()> replaced = {})
      : agent(std::move(name)), is_replaced(std::move(replaced)) {}
  Callee(const char* name) : agent(name) {}

  std::string agent;
  // Whether another serves in its place by now, so that its answer is waited for in vain; asked about once a second.
  std::function<bool()> is_replaced;
};

class Caller {
 public:
  Caller(AgentContext& context, const Service& service) : context_(context), service_(service) {}
  // The ID of a request to come, for a caller that names it to others.
  Datum next_id();
  // Under the given ID, or one of its own. Where the callee is replaced the request is withdrawn, and the failure is
  // `replaced`.
  Task<Result<Datum>> call(Callee callee, Datum operation, Duration timeout, Datum id = {});

 private:
  Task<Result<Answer>> ask(Datum request, Time deadline, std::function<bool()> is_replaced);

  AgentContext& context_;
  const Service& service_;
  std::uint64_t count_ = 0;
};

}  // namespace pizarra::runtime
