#include "agents/planner/explanation/why_never.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <set>

#include "agents/planner/explanation/never_together.hpp"
#include "agents/planner/explanation/no_plan.hpp"
#include "agents/planner/task/grounding.hpp"
#include "agents/planner/task/notation.hpp"
#include "lisp/nearest.hpp"
#include "lisp/pattern.hpp"
#include "lisp/writer.hpp"

namespace pizarra::planner {

namespace {

// Of facts, by one explanation.
constexpr std::size_t most_looked_at = 200;

// The wanted thing is a fact or `(not FACT)`, in which a variable stands for any object.
class WhyNever {
 public:
  WhyNever(const PlanningTask& task, const Problem& problem)
      : task_(task), initials_(task.initials.begin(), task.initials.end()), possible_(initials_) {
    for (const GroundAction& action : problem.actions) {
      for (const std::size_t added : action.adds) possible_.insert(problem.facts[added]);
      for (const std::size_t deleted : action.deletes) deleted_.insert(problem.facts[deleted]);
    }
  }

  bool possible(const Datum& wanted) const {
    if (!wanted.is_form("not")) {
      return std::ranges::any_of(possible_, [&](const Datum& fact) { return fits(wanted, fact); });
    }
    return !is_ground(wanted[1]) || !initials_.contains(wanted[1]) || deleted_.contains(wanted[1]);
  }

  // Goes from what is wanted to what that needs, nearest first, until something is missing for good.
  std::string explain(const Datum& fact, const std::function<bool()>& cancelled) {
    if (task_.counts_cost) ground_without_costs(cancelled);
    looked_at_ = {{fact, 0}};
    for (std::size_t i = 0; i < looked_at_.size() && !cancelled(); ++i) {
      const std::string end = look_at(i);
      if (!end.empty()) return chain(i) + end;
    }
    // Everything needs something else of it: the last is as good a place to begin as any.
    std::size_t last = looked_at_.size() - 1;
    while (last > 0 && !could_begin(last)) --last;
    return chain(last) + fmt::format("{} does not hold at the beginning, and only what needs it brings it about",
                                     text_of(looked_at_[last].wanted));
  }

 private:
  struct Looked {
    Datum wanted;
    std::size_t needed_by;
  };
  // One operator's way to bring something about.
  struct Way {
    const PlanningOperator& by;
    Bindings bindings;
  };

  static bool fits(const Datum& pattern, const Datum& fact) {
    Bindings ignored;
    return match(pattern, fact, ignored);
  }

  bool could_begin(std::size_t i) const {
    const Datum& wanted = looked_at_[i].wanted;
    return !wanted.is_form("not") && is_ground(wanted);
  }

  std::string chain(std::size_t end) const {
    std::string text;
    for (std::size_t i = end; i > 0; i = looked_at_[i].needed_by) {
      const std::string by = text_of(looked_at_[looked_at_[i].needed_by].wanted);
      text.insert(0, fmt::format("{} needs {}, and ", by, text_of(looked_at_[i].wanted)));
    }
    return text;
  }

  // How the explanation ends here, or nothing, and then there is more to look at.
  std::string look_at(std::size_t i) {
    const Datum wanted = looked_at_[i].wanted;
    std::string unpaid = look_at_costs(i);
    if (!unpaid.empty()) return unpaid;
    const std::vector<Way> ways = ways_to(wanted);
    if (ways.empty() && wanted.is_form("not")) {
      return fmt::format("{} holds from the beginning, and no operator ends that", text_of(wanted[1]));
    }
    std::string misfit = ways.empty() ? misfit_for(wanted) : std::string();
    if (!misfit.empty()) return misfit;
    if (ways.empty()) {
      return fmt::format("{} neither holds at the beginning nor is brought about by any operator{}", text_of(wanted),
                         name_meant(wanted.head()));
    }
    for (const Way& way : ways) {
      const std::string& name = way.by.name;
      for (const PlanningParameter& parameter : way.by.parameters) {
        if (has_objects(parameter.type)) continue;
        return fmt::format("{}, which brings {} about, takes a {}, and there is none", name, text_of(wanted),
                           parameter.type);
      }
      const std::vector<Datum> missing = missing_for(way);
      if (missing.empty() && !possible_without_costs(wanted)) {
        return fmt::format("{} needs {} for {}, and no objects have all of that", name, in_words(needed_for(way)),
                           text_of(wanted));
      }
      for (const Datum& needed : missing) look_later(needed, i);
    }
    return {};
  }

  void ground_without_costs(const std::function<bool()>& cancelled) {
    PlanningTask task = task_;
    task.counts_cost = false;
    Result<Problem> problem = ground(task, cancelled);
    if (!problem) return;
    const auto unpaid = [&](const GroundAction& action) { return cost_without_value(action).has_value(); };
    if (std::ranges::any_of(problem->actions, unpaid)) without_costs_ = std::move(*problem);
  }

  bool brings_about(const GroundAction& action, const Datum& wanted) const {
    const bool absent = wanted.is_form("not");
    const Datum& pattern = absent ? wanted[1] : wanted;
    return std::ranges::any_of(absent ? action.deletes : action.adds,
                               [&](std::size_t fact) { return fits(pattern, without_costs_.facts[fact]); });
  }

  bool possible_without_costs(const Datum& wanted) const {
    return std::ranges::any_of(without_costs_.actions,
                               [&](const GroundAction& action) { return brings_about(action, wanted); });
  }

  // An action that would bring it about, if only what it costs had a value. Of one that needs such an action first,
  // what it needs is looked at later.
  std::string look_at_costs(std::size_t i) {
    const Datum wanted = looked_at_[i].wanted;
    for (const GroundAction& action : without_costs_.actions) {
      if (!brings_about(action, wanted)) continue;
      if (const std::optional<Datum> cost = cost_without_value(action)) {
        const std::string missing = text_of(*cost);
        return fmt::format("{} costs {}, and {} has no value", text_of(action.name), missing, missing);
      }
      for (const std::size_t fact : action.preconditions) {
        if (!possible(without_costs_.facts[fact])) look_later(without_costs_.facts[fact], i);
      }
    }
    return {};
  }

  std::optional<Datum> cost_without_value(const GroundAction& action) const {
    const auto op = std::ranges::find(task_.operators, action.name.head(), &PlanningOperator::name);
    Bindings bindings;
    for (std::size_t i = 0; i < op->parameters.size(); ++i) {
      bindings.bind(Datum::symbol(op->parameters[i].variable), action.name[i + 1]);
    }
    for (const Datum& cost : op->costs) {
      Datum function = substitute(cost, bindings);
      if (function.is_list() && !task_.values.contains(function)) return function;
    }
    return std::nullopt;
  }

  // Where nothing is declared, what nothing brings about may be a slip of the pen.
  std::string name_meant(std::string_view predicate) const {
    if (!task_.angles) return {};
    std::set<std::string> known;
    for (const Datum& fact : initials_) known.emplace(fact.head());
    for (const PlanningOperator& op : task_.operators) {
      for (const Datum& added : op.adds) known.emplace(added.head());
    }
    const std::string nearest = known.contains(std::string(predicate)) ? "" : nearest_name(predicate, known);
    return nearest.empty() ? nearest : fmt::format("; the nearest is {}", nearest);
  }

  void look_later(const Datum& wanted, std::size_t needed_by) {
    if (looked_at_.size() == most_looked_at) return;
    if (std::ranges::find(looked_at_, wanted, &Looked::wanted) != looked_at_.end()) return;
    looked_at_.push_back({wanted, needed_by});
  }

  bool has_objects(const std::string& type) const {
    return std::ranges::any_of(
        task_.objects, [&](const PlanningObject& object) { return is_subtype(task_.types, object.type, type); });
  }

  std::vector<Way> ways_to(const Datum& wanted) const {
    const bool absent = wanted.is_form("not");
    std::vector<Way> ways;
    for (const PlanningOperator& op : task_.operators) {
      for (const Datum& effect : absent ? op.deletes : op.adds) {
        std::optional<Bindings> bindings = unified(effect, absent ? wanted[1] : wanted);
        if (bindings && takes(op, *bindings)) ways.push_back({op, std::move(*bindings)});
      }
    }
    return ways;
  }

  // The values of the effect's variables where the effect is the wanted fact.
  static std::optional<Bindings> unified(const Datum& effect, const Datum& wanted) {
    if (effect.head() != wanted.head() || effect.size() != wanted.size()) return std::nullopt;
    Bindings bindings;
    for (std::size_t i = 1; i < effect.size(); ++i) {
      if (is_variable(wanted[i])) continue;
      const bool same = is_variable(effect[i]) ? bindings.bind(effect[i], wanted[i]) : effect[i] == wanted[i];
      if (!same) return std::nullopt;
    }
    return bindings;
  }

  // Whether the bound objects are of the types that the operator takes, as far as there are any.
  bool takes(const PlanningOperator& op, const Bindings& bindings) const {
    return std::ranges::none_of(op.parameters, [&](const PlanningParameter& parameter) {
      return has_objects(parameter.type) && misfitting(parameter, bindings) != nullptr;
    });
  }

  // The object bound to the parameter, where its type is another one.
  const PlanningObject* misfitting(const PlanningParameter& parameter, const Bindings& bindings) const {
    const Datum* name = bindings.find(parameter.variable);
    if (name == nullptr) return nullptr;
    const auto object = std::ranges::find(task_.objects, *name, &PlanningObject::name);
    const bool fits = object == task_.objects.end() || is_subtype(task_.types, object->type, parameter.type);
    return fits ? nullptr : &*object;
  }

  // An operator that would bring it about for objects of other types.
  std::string misfit_for(const Datum& wanted) const {
    for (const PlanningOperator& op : task_.operators) {
      for (const Datum& effect : op.adds) {
        const std::optional<Bindings> bindings = unified(effect, wanted);
        if (!bindings) continue;
        for (const PlanningParameter& parameter : op.parameters) {
          const PlanningObject* object = misfitting(parameter, *bindings);
          if (object == nullptr) continue;
          return fmt::format("{}, which brings {} about, takes a {} for {}, and {} is a {}", op.name, text_of(effect),
                             parameter.type, text_of(Datum::symbol(parameter.variable)), write(object->name),
                             object->type);
        }
      }
    }
    return {};
  }

  static std::vector<Datum> needed_for(const Way& way) {
    std::vector<Datum> needed;
    for (const Datum& atom : way.by.preconditions) needed.push_back(substitute(atom, way.bindings));
    for (const Datum& atom : way.by.absents) needed.push_back(list("not"_sym, substitute(atom, way.bindings)));
    for (const PlanningEquality& equality : way.by.equalities) {
      const Datum equal = substitute(list("="_sym, equality.left, equality.right), way.bindings);
      needed.push_back(equality.equal ? equal : list("not"_sym, equal));
    }
    return needed;
  }

  std::vector<Datum> missing_for(const Way& way) const {
    std::vector<Datum> missing = needed_for(way);
    std::erase_if(missing, [&](const Datum& needed) {
      const Datum& fact = needed.is_form("not") ? needed[1] : needed;
      return fact.is_form("=") || possible(needed);
    });
    return missing;
  }

  std::string in_words(const std::vector<Datum>& needed) const {
    std::string words;
    for (const Datum& one : needed) words += (words.empty() ? "" : " and ") + text_of(one);
    return words.empty() ? "its objects" : words;
  }

  std::string text_of(const Datum& datum) const { return written(task_, datum); }

  const PlanningTask& task_;
  std::set<Datum> initials_;
  std::set<Datum> possible_;  // if nothing were ever deleted
  std::set<Datum> deleted_;
  Problem without_costs_;  // where a cost without a value makes an action impossible
  std::vector<Looked> looked_at_;
};

}  // namespace

std::string why_never(const PlanningTask& task, const Problem& problem, const Datum& fact,
                      const std::function<bool()>& cancelled) {
  WhyNever why(task, problem);
  if (why.possible(fact)) return never_together_in_words(task, problem, fact, cancelled);
  const std::string nothing = task.initials.empty() ? "; nothing at all holds at the beginning" : "";
  return why.explain(fact, cancelled) + nothing;
}

}  // namespace pizarra::planner
