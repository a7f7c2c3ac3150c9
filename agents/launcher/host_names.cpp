#include "agents/launcher/host_names.hpp"

#include <algorithm>

#include "agents/runtime/naming.hpp"
#include "agents/runtime/own_name.hpp"

namespace pizarra::launcher {

namespace {

const Datum any = "?"_sym;

// Of processes, each by the name of its agent, where that is present.
Transaction bindings_of(const std::vector<Supervisor::Process>& processes, const std::vector<Fact>& present,
                        const std::string& host, LeaseId lease) {
  const Datum context = list("cell"_sym, "hosts"_sym, Datum::symbol(host));
  Transaction changes;
  for (const Supervisor::Process& process : processes) {
    if (process.given_up) {
      changes.retract(list("bound"_sym, context, Datum::symbol(process.name), any, any));
      continue;
    }
    const auto agent = std::ranges::find_if(present, [&](const Fact& fact) {
      return fact.datum[1].is_symbol(process.name) && fact.datum[3].text() == host;
    });
    if (agent == present.end()) continue;
    const runtime::Reference reference{std::string(agent->datum[2].text()), process.name};
    const Transaction binding = runtime::binding_in({"cell", "hosts", host}, reference, lease);
    changes.steps.insert(changes.steps.end(), binding.steps.begin(), binding.steps.end());
  }
  return changes;
}

}  // namespace

Task<void> bind_processes(Board& board, std::string host, std::vector<Supervisor::Process> processes, LeaseId lease) {
  std::vector<Relation> relations = runtime::naming_relations();
  const Result<void> declared = co_await board.declare(std::move(relations));
  if (!declared) co_return;
  const Datum agents = list("agent"_sym, any, any, any);
  const Result<std::vector<Fact>> present = co_await board.facts(agents);
  if (!present) co_return;
  Transaction changes = bindings_of(processes, *present, host, lease);
  [[maybe_unused]] const Result<Revision> bound = co_await board.transact(std::move(changes));
}

}  // namespace pizarra::launcher
