#include "agents/planner/why_never.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <set>

#include "lisp/pattern.hpp"
#include "lisp/writer.hpp"

namespace pizarra {

namespace {

constexpr std::size_t longest_chain = 8;

class WhyNever {
 public:
  WhyNever(const PlanningTask& task, const Problem& problem)
      : task_(task), reachable_(task.initials.begin(), task.initials.end()) {
    for (const GroundAction& action : problem.actions) {
      for (const std::size_t added : action.adds) reachable_.insert(problem.facts[added]);
    }
  }

  std::string explain(Datum fact) const {
    std::string chain;
    for (std::size_t i = 0; i < longest_chain; ++i) {
      const std::string link = chain.empty() ? std::string() : ", and ";
      const std::optional<Datum> missing = missing_for(fact);
      if (!missing) return chain;
      if (*missing == Datum()) return chain + link + fmt::format("no operator brings about {}", write(fact));
      chain += link + fmt::format("{} needs {}", write(fact), write(*missing));
      if (!is_ground(*missing)) return chain + ", which never holds";
      fact = *missing;
    }
    return chain;
  }

 private:
  // A precondition that never holds, of the first operator that adds the fact; () where none adds it.
  std::optional<Datum> missing_for(const Datum& fact) const {
    std::optional<Datum> found = Datum();
    for (const PlanningOperator& op : task_.operators) {
      for (const Datum& added : op.adds) {
        Bindings bindings;
        if (!match(added, fact, bindings) || !takes(op, bindings)) continue;
        const std::optional<Datum> missing = missing_precondition(op, bindings);
        if (!missing) return std::nullopt;
        if (found == Datum()) found = missing;
      }
    }
    return found;
  }

  // Whether the bound objects are of the types that the operator takes.
  bool takes(const PlanningOperator& op, const Bindings& bindings) const {
    return std::ranges::all_of(op.parameters, [&](const PlanningParameter& parameter) {
      const Datum* name = bindings.find(parameter.variable);
      if (name == nullptr) return true;
      const auto object = std::ranges::find(task_.objects, *name, &PlanningObject::name);
      return object != task_.objects.end() && is_subtype(task_.types, object->type, parameter.type);
    });
  }

  std::optional<Datum> missing_precondition(const PlanningOperator& op, const Bindings& bindings) const {
    for (const Datum& precondition : op.preconditions) {
      const Datum wanted = substitute(precondition, bindings);
      const bool never = std::ranges::none_of(reachable_, [&](const Datum& fact) {
        Bindings found;
        return match(wanted, fact, found);
      });
      if (never) return wanted;
    }
    return std::nullopt;
  }

  const PlanningTask& task_;
  std::set<Datum> reachable_;
};

}  // namespace

std::string why_never(const PlanningTask& task, const Problem& problem, const Datum& fact) {
  return fact.is_form("not") ? std::string() : WhyNever(task, problem).explain(fact);
}

}  // namespace pizarra
