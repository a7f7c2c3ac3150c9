#pragma once

// The dialogue with the planning server (steps d to f): operators, facts and goals go there, a plan comes back.

#include "agents/coordinator/event_log.hpp"
#include "agents/coordinator/perceive/presence.hpp"
#include "agents/coordinator/perceive/surroundings.hpp"

namespace pizarra::coordinator {

class Planning {
 public:
  Planning(runtime::AgentContext& context, const CoordinatorOptions& options, const TaskDomain& domain,
           Presence& presence, const Surroundings& surroundings, runtime::Caller& caller)
      : context_(context),
        options_(options),
        domain_(domain),
        presence_(presence),
        surroundings_(surroundings),
        caller_(caller) {}

  // A plan from what is believed now, one operation after another; empty where the goal holds. Failures: no-plan
  // (proved), gave-up, absent, and what the planner says of a task it cannot read.
  Task<Result<std::vector<GroundOperation>>> plan(std::vector<Datum> goal);
  // Asks for operation `index` of the plan that was handed out last, as the planner remembers it; nothing where it does
  // not.
  Task<std::optional<Datum>> operation(std::size_t index);

 private:
  Task<Result<Datum>> ask(Datum operation);
  Datum operators() const;
  Datum task(const std::vector<Datum>& goal) const;

  runtime::AgentContext& context_;
  const CoordinatorOptions& options_;
  const TaskDomain& domain_;
  Presence& presence_;
  const Surroundings& surroundings_;
  runtime::Caller& caller_;
};

}  // namespace pizarra::coordinator
