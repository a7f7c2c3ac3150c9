#pragma once

// The main of an agent that is a program of its own:
//
//   int main(int argc, char** argv) { return runtime::agent_main<Counter>("counter", argc, argv); }
//
// Typed as `counter BOARD-ADDRESS [--name NAME] [--key FILE]`, it runs the agent on that board, under that name, until
// Ctrl-C or SIGTERM. Exit status: 0 then, 1 where the agent fails, 2 where the words, the address or the key are wrong.

#include <functional>
#include <memory>
#include <string>

#include "agents/runtime/agent.hpp"

namespace pizarra::runtime {

using MakeAgent = std::function<std::unique_ptr<Agent>(AgentContext)>;

// `name` is how the agent is called where --name does not say otherwise.
int agent_main(const std::string& name, int argc, char** argv, const MakeAgent& make);

template <class A>
int agent_main(const std::string& name, int argc, char** argv) {
  return agent_main(name, argc, argv, [](AgentContext context) { return std::make_unique<A>(std::move(context)); });
}

}  // namespace pizarra::runtime
