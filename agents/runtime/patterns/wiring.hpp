#pragma once

// WIRING: a master says who serves whom, while they run. A client calls a role; which server plays it is a fact, so
// that it can be changed at any moment, by anybody who may tell it, a person at the prompt included.
//
//   (wired CLIENT ROLE SERVER)      durable
//
//   co_await wire(board, "coordinator", "eyes", "vision-2");          // the master
//   Wired eyes(context, caller, "eyes");                              // in the client
//   Result<Datum> seen = co_await eyes.call(list("get-objects"_sym), 2s);
//
// A call that is under way stays with the server that it went to; the next goes to the new one.

#include "agents/runtime/service.hpp"

namespace pizarra::runtime {

Relation wired_relation();

Task<Result<void>> wire(Board& board, std::string client, std::string role, std::string server);
Task<Result<void>> unwire(Board& board, std::string client, std::string role);

class Wired {
 public:
  Wired(AgentContext& context, Caller& caller, std::string role)
      : context_(context), caller_(caller), role_(std::move(role)) {}
  // Waits to be wired. Failures not-wired, and those of Caller::call.
  Task<Result<Datum>> call(Datum operation, Duration patience);

 private:
  AgentContext& context_;
  Caller& caller_;
  const std::string role_;
};

}  // namespace pizarra::runtime
