#pragma once

// The commands about names of agents in the tree of contexts: bind, rebind, unbind, resolve, list, and find, which goes
// by properties. A name that is bound here goes with the prompt.
//
//   NameCommands names(prompt, service);
//   Evaluation outcome = co_await names.bind(typed);       // (bind (cell arms left) robot)

#include "agents/repl/prompt.hpp"
#include "agents/runtime/naming.hpp"

namespace pizarra::repl {

class NameCommands {
 public:
  // Both outlive it.
  NameCommands(Prompt& prompt, const runtime::Service& service) : prompt_(prompt), naming_(prompt.context, service) {}

  // (bind PATH AGENT), (rebind PATH AGENT)
  Task<Evaluation> bind(Typed typed);
  Task<Evaluation> unbind(Typed typed);
  Task<Evaluation> resolve(Typed typed);
  // (list), (list PATH)
  Task<Evaluation> list_names(Typed typed);
  Task<Evaluation> find(Typed typed);

 private:
  // What is present under this name.
  Task<Result<runtime::Reference>> agent_called(std::string name);

  Prompt& prompt_;
  runtime::Naming naming_;
};

}  // namespace pizarra::repl
