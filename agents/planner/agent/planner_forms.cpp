#include "agents/planner/agent/planner_forms.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "lisp/forms/goal_formula.hpp"
#include "lisp/pattern.hpp"
#include "lisp/writer.hpp"

namespace pizarra::planner {

namespace {

// `<ob1>` as `?ob1`, everywhere in the datum.
Datum with_variables(const Datum& datum) {
  if (datum.is_list()) {
    std::vector<Datum> items;
    for (const Datum& item : datum.items()) items.push_back(with_variables(item));
    return Datum::list(std::move(items));
  }
  const std::string_view name = datum.text();
  if (!datum.is_symbol() || name.size() < 3 || name.front() != '<' || name.back() != '>') return datum;
  return Datum::symbol(fmt::format("?{}", name.substr(1, name.size() - 2)));
}

// A predicate with names behind it, none of them a list.
bool is_atom(const Datum& datum) {
  if (datum.head().empty() || is_variable(datum[0]) || datum.is_form("del")) return false;
  return std::ranges::none_of(datum.items(), &Datum::is_list);
}

std::unexpected<Failure> bad_operator(const std::string& name, std::string_view what, const Datum& subject) {
  return fail("bad-operator", fmt::format("{}: {}, not {}", name, what, write(subject)), subject);
}

Result<void> read_params(PlanningOperator& to, const Datum& params) {
  for (const Datum& param : params.items().subspan(1)) {
    const bool fits = param.size() == 2 && is_variable(param[0]) && param[0].text().size() > 1 && param[1].is_symbol();
    if (!fits) return bad_operator(to.name, "a parameter is (<NAME> TYPE)", param);
    to.parameters.push_back({std::string(param[0].text()), std::string(param[1].text())});
  }
  return {};
}

Result<void> read_preconds(PlanningOperator& to, const Datum& preconds) {
  for (const Datum& atom : preconds.items().subspan(1)) {
    if (!is_atom(atom)) return bad_operator(to.name, "a precondition is (PREDICATE NAME ...)", atom);
    to.preconditions.push_back(atom);
  }
  return {};
}

Result<void> read_effects(PlanningOperator& to, const Datum& effects) {
  for (const Datum& effect : effects.items().subspan(1)) {
    Datum atom = effect;
    if (effect.is_form("del") && effect.size() == 2 && effect[1].is_list()) {
      atom = effect[1];
    } else if (effect.is_form("del")) {
      atom = Datum::list({effect.items().begin() + 1, effect.items().end()});
    }
    if (!is_atom(atom)) return bad_operator(to.name, "an effect is (PREDICATE NAME ...) or (del FACT)", effect);
    (effect.is_form("del") ? to.deletes : to.adds).push_back(std::move(atom));
  }
  return {};
}

}  // namespace

Result<PlanningOperator> operator_from_form(const Datum& form) {
  if (!form.is_form("operator") || form.size() != 5 || !form[1].is_symbol()) {
    return fail("bad-operator",
                "an operator is (operator NAME (params ...) (preconds ...) (effects ...)), not " + write(form), form);
  }
  const Datum read = with_variables(form);
  PlanningOperator to{
      .name = std::string(form[1].text()), .parameters = {}, .preconditions = {}, .adds = {}, .deletes = {}};
  constexpr std::string_view names[] = {"params", "preconds", "effects"};
  constexpr Result<void> (*readers[])(PlanningOperator&, const Datum&) = {read_params, read_preconds, read_effects};
  for (std::size_t i = 0; i < std::size(names); ++i) {
    const Datum& part = read[i + 2];
    if (!part.is_form(names[i])) return bad_operator(to.name, fmt::format("({} ...) is expected here", names[i]), part);
    const Result<void> done = readers[i](to, part);
    if (!done) return fail(done);
  }
  return to;
}

Result<std::vector<PlanningOperator>> operators_from_list(const Datum& operators) {
  if (operators.size() == 0) return fail("bad-operator", "there must be at least one operator", operators);
  std::vector<PlanningOperator> read;
  for (const Datum& form : operators.items()) {
    Result<PlanningOperator> one = operator_from_form(form);
    if (!one) return fail(one);
    if (std::ranges::find(read, one->name, &PlanningOperator::name) != read.end()) {
      return fail("bad-operator", one->name + " is the name of two operators", form[1]);
    }
    read.push_back(std::move(*one));
  }
  return read;
}

namespace {

// Whether it has a quantifier's (<x> TYPE), and one form under it.
bool is_quantified(const Datum& form, std::size_t at) {
  return form.size() == at + 2 && form[at].size() == 2 && form[at][0].is_symbol() && form[at][1].is_symbol();
}

}  // namespace

// Formulas as lisp/forms/goal_formula.hpp has them.
Result<void> check_goal_form(const Datum& form) {
  const bool counts = form.is_form("at-least");
  std::size_t first = 0;  // of the forms within
  bool sound = is_atom(form) && is_ground(form);
  if (form.is_form("and") || form.is_form("or")) {
    sound = form.size() > 1;
    first = 1;
  } else if (form.is_form("not")) {
    sound = form.size() == 2;
    first = 1;
  } else if (form.is_form("forall") || form.is_form("exists") || counts) {
    first = counts ? 3 : 2;
    sound = is_quantified(form, first - 1) && (!counts || form[1].is_integer());
  } else if (form.is_form("=")) {
    sound = sound && form.size() == 3;
  }
  if (!sound) return fail("bad-facts", fmt::format("a goal is no such form as {}", write(form)), form);
  if (first == 0) return {};
  for (const Datum& part : form.items().subspan(first)) {
    const Result<void> inner = check_goal_form(part);
    if (!inner) return inner;
  }
  return {};
}

Result<PlanningFacts> facts_from_forms(const Datum& types, const Datum& initials, const Datum& goals) {
  const std::pair<const Datum&, std::string_view> parts[] = {
      {types, "types"}, {initials, "initials"}, {goals, "goals"}};
  for (const auto& [part, name] : parts) {
    if (!part.is_form(name))
      return fail("bad-facts", fmt::format("({} ...) is expected, not {}", name, write(part)), part);
  }
  PlanningFacts facts;
  for (const Datum& type : types.items().subspan(1)) {
    if (type.size() != 2 || type[0].is_list() || is_variable(type[0]) || !type[1].is_symbol()) {
      return fail("bad-facts", "a type is given as (OBJECT TYPE), not " + write(type), type);
    }
    facts.objects.push_back({type[0], std::string(type[1].text())});
  }
  for (const Datum& fact : initials.items().subspan(1)) {
    if (!is_atom(fact) || !is_ground(fact)) {
      return fail("bad-facts", fmt::format("a fact is (PREDICATE OBJECT ...), not {}", write(fact)), fact);
    }
    facts.initials.push_back(fact);
  }
  for (const Datum& goal : goals.items().subspan(1)) {
    const Result<void> sound = check_goal_form(goal);
    if (!sound) return fail(sound);
    facts.goals.push_back(goal);
  }
  if (facts.goals.empty()) return fail("bad-facts", "there must be at least one goal", goals);
  return facts;
}

Datum steps_to_datum(const PlanSteps& steps) {
  std::vector<Datum> items;
  for (const std::vector<Datum>& step : steps) items.push_back(Datum::list(step));
  return Datum::list(std::move(items));
}

std::vector<Datum> operations_of(const PlanSteps& steps) {
  std::vector<Datum> operations;
  for (const std::vector<Datum>& step : steps) operations.insert(operations.end(), step.begin(), step.end());
  return operations;
}

Failure as_asked(Failure failure) {
  failure.subject = forms::without_variables(failure.subject);
  return failure;
}

}  // namespace pizarra::planner
