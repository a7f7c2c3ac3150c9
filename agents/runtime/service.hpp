#pragma once

// Requests and replies as facts. `(request ID AGENT (operation args...))` is taken by the agent and answered by
// `(reply ID (ok value...))` or `(reply ID (fail symbol "sentence" subject))`, told together with settling the request.
// A request whose ID has been answered already is answered again the same way without being done again (the newest
// are remembered). An agent that dies before it replied leaves the request to its successor.
//
//   Task<Result<void>> VisionAgent::run() {
//     Service service(context_, contract());
//     Result<void> started = co_await service.start();          // declares, presence lease, contract fact
//     if (!started) co_return started;
//     co_return co_await service.serve([this](Datum operation) { return handle(std::move(operation)); });
//   }
//
// Requests are handled concurrently, each in a job of its own, `max_concurrent` at most: an agent that does one thing
// at a time says so by failing with `busy`.

#include <functional>
#include <map>

#include "agents/runtime/presence.hpp"

namespace pizarra::runtime {

// What the handler answers: the elements after `ok`, a list.
using Handler = std::function<Task<Result<Datum>>(Datum operation)>;
// The same for an agent that must know who asks: the request as it was told.
using RequestHandler = std::function<Task<Result<Datum>>(Fact request)>;

class Service {
 public:
  static constexpr std::size_t max_concurrent = 64;

  Service(AgentContext& context, Contract contract);
  ~Service();

  // Until the agent is there (presence.hpp).
  Task<Result<void>> start() { return presence_.start(); }
  // Serves until destroyed, or until the board or the presence is lost for good.
  Task<Result<void>> serve(Handler handler);
  Task<Result<void>> serve_requests(RequestHandler handler);
  // In an orderly way: takes no more requests, lets those in hand be answered, `patience` at most, and frees the name
  // at once. What is not answered is left to a successor.
  Task<Result<void>> leave(Duration patience);
  // The lease under which this agent's presence, and whatever should go with it, stands.
  LeaseId presence() const { return presence_.lease(); }

 private:
  struct Running;
  AgentContext& context_;
  Contract contract_;
  Presence presence_;
  std::unique_ptr<Running> running_;

  Task<Result<void>> follow(Watch& watch);
  Task<Result<std::optional<Fact>>> take(Datum request);
  Task<void> answer_request(Fact request);
  Task<Datum> work_out(Fact request);
  Task<Result<Revision>> deliver(Datum reply);
};

}  // namespace pizarra::runtime
