#pragma once

// SEND: the client starts, one way, nobody waits. The operation is on the board when this is done; the agent does it
// when it comes to it, its successor if it dies, and what it answers goes by itself.
//
//   Sender sender(context, service);
//   co_await sender.send("pan-tilt", list("pan"_sym, 30));
//
// Items that have not been taken go with the sender's presence.

#include "agents/runtime/service.hpp"

namespace pizarra::runtime {

class Sender {
 public:
  Sender(AgentContext& context, const Service& service) : context_(context), service_(service) {}
  Task<Result<void>> send(std::string agent, Datum operation);

 private:
  AgentContext& context_;
  const Service& service_;
  std::uint64_t count_ = 0;
};

}  // namespace pizarra::runtime
