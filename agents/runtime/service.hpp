#pragma once

// Requests and replies as facts. `(request ID AGENT (operation args...))` is taken by the agent and answered by
// `(reply ID (ok value...))` or `(reply ID (fail symbol "sentence" subject))`, told together with settling the request.
// A request whose ID has been answered already is answered again the same way without being done again (the last 256
// are remembered). An agent that dies before it replied leaves the request to its successor.
//
//   Task<Result<void>> VisionAgent::run() {
//     Service service(context_, contract());
//     Result<void> started = co_await service.start();          // declares, presence lease, contract fact
//     if (!started) co_return started;
//     co_return co_await service.serve([this](Datum operation) { return handle(std::move(operation)); });
//   }
//
// Requests are handled concurrently, each in a job of its own, at most 64 at once: an agent that does one thing at a
// time says so by failing with `busy`.

#include <functional>
#include <map>
#include <set>

#include "agents/runtime/agent.hpp"
#include "agents/runtime/contract.hpp"

namespace pizarra::runtime {

// What the handler answers: the elements after `ok`, a list.
using Handler = std::function<Task<Result<Datum>>(Datum operation)>;
// The same for an agent that must know who asks: the request as it was told.
using RequestHandler = std::function<Task<Result<Datum>>(Fact request)>;

class Service {
 public:
  static constexpr Duration presence_lease = 2s;
  static constexpr Duration presence_renewal = 500ms;
  static constexpr std::size_t max_concurrent = 64;

  Service(AgentContext& context, Contract contract);
  ~Service();

  // Declares the runtime's and the contract's relations, waits until the name is free, tells presence and contract. An
  // agent that offers anything is bound by its name (own_name.hpp), where its key lets it.
  Task<Result<void>> start();
  // Serves until destroyed, or until the board or the presence is lost for good.
  Task<Result<void>> serve(Handler handler);
  Task<Result<void>> serve_requests(RequestHandler handler);
  // In an orderly way: takes no more requests, lets those in hand be answered, `patience` at most, and frees the name
  // at once. What is not answered is left to a successor.
  Task<Result<void>> leave(Duration patience);
  // The lease under which this agent's presence, and whatever should go with it, stands.
  LeaseId presence() const { return presence_; }

 private:
  struct Running;
  AgentContext& context_;
  Contract contract_;
  LeaseId presence_ = 0;
  bool names_declared_ = false;
  bool may_bind_ = true;
  std::unique_ptr<Running> running_;

  Task<Result<void>> declare();
  Transaction presence_facts(LeaseId lease) const;
  Task<Result<void>> announce();
  Task<void> keep_presence();
  Task<void> bind_own_name();
  Task<Result<void>> follow(Watch& watch);
  Task<Result<std::optional<Fact>>> take(Datum request);
  Task<void> answer_request(Fact request);
  Task<Datum> work_out(Fact request);
  Task<Result<Revision>> deliver(Datum reply);
};

// Asks another agent for something and waits for the reply's `ok` elements as a list. Failures: those of the agent,
// and `timeout` (the request is then withdrawn). Request ids are NAME-PRESENCE-COUNT, unique on one board. Who asks is
// present: a request goes when the presence of its caller lapses. A program that offers nothing has a Service with an
// empty contract.
class Caller {
 public:
  // Whether nobody waits for the answer any more; asked about once a second.
  using GiveUp = std::function<bool()>;

  Caller(AgentContext& context, const Service& service) : context_(context), service_(service) {}
  // The ID of a request to come, for a caller that names it to others.
  Datum next_id();
  // Under the given ID, or one of its own. Given up, the request is withdrawn and the failure is `replaced`.
  Task<Result<Datum>> call(std::string agent, Datum operation, Duration timeout, GiveUp give_up = {}, Datum id = {});

 private:
  Task<Result<Answer>> ask(Datum request, Time deadline, GiveUp give_up);

  AgentContext& context_;
  const Service& service_;
  std::uint64_t count_ = 0;
};

}  // namespace pizarra::runtime
