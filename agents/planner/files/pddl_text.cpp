#include "agents/planner/files/pddl_text.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <set>

#include "lisp/pattern.hpp"
#include "lisp/writer.hpp"

namespace pizarra::planner {

namespace {

// Names of one kind, each a different word of PDDL, in the order they are asked for.
class PddlNames {
 public:
  explicit PddlNames(std::set<std::string> reserved = {}) : taken_(std::move(reserved)) {}

  const std::string& of(const Datum& name) {
    const auto [known, is_new] = names_.try_emplace(name);
    if (is_new) known->second = unique(word(name));
    return known->second;
  }
  const std::string& of(std::string_view name) { return of(Datum::symbol(name)); }

  // Those asked for so far.
  std::vector<std::string> all() const {
    std::vector<std::string> words;
    for (const auto& [name, word] : names_) words.push_back(word);
    return words;
  }

 private:
  static std::string word(const Datum& name) {
    std::string word = name.is_symbol() || name.is_string() ? std::string(name.text()) : "n" + write(name);
    for (char& c : word) {
      if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
      const bool good = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
      if (!good) c = '_';
    }
    const bool begins_well = !word.empty() && word.front() >= 'a' && word.front() <= 'z';
    return begins_well ? word : "n" + word;
  }

  std::string unique(const std::string& wanted) {
    std::string name = wanted;
    for (std::size_t i = 2; !taken_.insert(name).second; ++i) name = fmt::format("{}-{}", wanted, i);
    return name;
  }

  std::map<Datum, std::string> names_;
  std::set<std::string> taken_;
};

// Where every type is one by itself, none of them may be PDDL's `object`, which all objects have.
std::set<std::string> reserved_types(const PlanningTask& task) {
  std::set<std::string> reserved{"number", "either"};
  if (task.types.empty()) reserved.insert("object");
  return reserved;
}

bool names_objects(const PlanningTask& task) {
  const auto is_object = [](const Datum& term) { return !is_variable(term); };
  const auto names_one = [&](const std::vector<Datum>& atoms) {
    return std::ranges::any_of(atoms, [&](const Datum& atom) {
      return atom.is_list() && std::ranges::any_of(atom.items().subspan(1), is_object);
    });
  };
  return std::ranges::any_of(task.operators, [&](const PlanningOperator& op) {
    const bool in_equality = std::ranges::any_of(op.equalities, [&](const PlanningEquality& equality) {
      return is_object(equality.left) || is_object(equality.right);
    });
    return in_equality || names_one(op.preconditions) || names_one(op.absents) || names_one(op.adds) ||
           names_one(op.deletes) || names_one(op.costs);
  });
}

class PddlWriter {
 public:
  explicit PddlWriter(const PlanningTask& task)
      : task_(task), names_objects_(names_objects(task)), types_(reserved_types(task)) {}

  PddlText run() {
    for (const PlanningOperator& op : task_.operators) actions_ += action(op);
    PddlText text;
    text.problem = problem();  // before the domain, which declares what it speaks of
    text.domain = domain();
    for (const PlanningObject& object : task_.objects) text.objects.emplace(objects_.of(object.name), object.name);
    for (const PlanningOperator& op : task_.operators) {
      text.operators.emplace(operators_.of(op.name), Datum::symbol(op.name));
    }
    return text;
  }

 private:
  bool flat() const { return task_.types.empty(); }

  std::string term(const Datum& name) {
    if (is_variable(name)) return "?" + variables_.of(name.text().substr(1));
    return objects_.of(name);
  }

  std::string atom(const Datum& fact, PddlNames& heads, std::map<std::string, std::size_t>& declared) {
    const std::string& head = heads.of(fact.head());
    declared.emplace(head, fact.size() - 1);
    std::string text = "(" + head;
    for (const Datum& argument : fact.items().subspan(1)) text += " " + term(argument);
    return text + ")";
  }
  std::string fact(const Datum& datum) { return atom(datum, predicates_, declared_predicates_); }
  std::string function(const Datum& datum) { return atom(datum, functions_, declared_functions_); }

  std::string condition(const std::vector<Datum>& facts, const std::vector<Datum>& absents,
                        const std::vector<PlanningEquality>& equalities) {
    std::string text = "(and";
    for (const Datum& datum : facts) text += " " + fact(datum);
    for (const Datum& datum : absents) text += " (not " + fact(datum) + ")";
    for (const PlanningEquality& equality : equalities) {
      const std::string equal = fmt::format("(= {} {})", term(equality.left), term(equality.right));
      text += equality.equal ? " " + equal : " (not " + equal + ")";
    }
    return text + ")";
  }

  std::string action(const PlanningOperator& op) {
    std::string parameters;
    for (const PlanningParameter& parameter : op.parameters) {
      parameters += fmt::format("{}{} - {}", parameters.empty() ? "" : " ", term(Datum::symbol(parameter.variable)),
                                types_.of(parameter.type));
    }
    std::string effect = "(and";
    for (const Datum& datum : op.adds) effect += " " + fact(datum);
    for (const Datum& datum : op.deletes) effect += " (not " + fact(datum) + ")";
    for (const Datum& cost : op.costs) {
      if (!task_.counts_cost) break;
      effect += fmt::format(" (increase (total-cost) {})", cost.is_integer() ? write(cost) : function(cost));
    }
    return fmt::format("  (:action {}\n    :parameters ({})\n    :precondition {}\n    :effect {})\n",
                       operators_.of(op.name), parameters, condition(op.preconditions, op.absents, op.equalities),
                       effect + ")");
  }

  // Objects that an operator names must be constants of the domain: then all are.
  std::string objects(bool in_domain) {
    if (in_domain != names_objects_) return {};
    std::string text = in_domain ? "\n  (:constants" : "\n  (:objects";
    for (const PlanningObject& object : task_.objects) {
      text += fmt::format("\n    {} - {}", objects_.of(object.name), types_.of(object.type));
    }
    return text + ")";
  }

  std::string problem() {
    std::string initials;
    for (const Datum& datum : task_.initials) initials += "\n    " + fact(datum);
    if (task_.counts_cost) initials += "\n    (= (total-cost) 0)";
    for (const auto& [name, value] : task_.values) {
      if (!task_.counts_cost || name.head() == "total-cost") continue;
      initials += fmt::format("\n    (= {} {})", function(name), value);
    }
    return fmt::format("(define (problem task)\n  (:domain pizarra){}\n  (:init{})\n  (:goal {}){})\n", objects(false),
                       initials, condition(task_.goals, task_.absent_goals, {}),
                       task_.counts_cost ? "\n  (:metric minimize (total-cost))" : "");
  }

  std::string requirements() const {
    std::string text = ":strips :typing";
    const auto any = [&](auto has) { return std::ranges::any_of(task_.operators, has); };
    if (!task_.absent_goals.empty() || any([](const PlanningOperator& op) { return !op.absents.empty(); })) {
      text += " :negative-preconditions";
    }
    if (any([](const PlanningOperator& op) { return !op.equalities.empty(); })) text += " :equality";
    if (task_.counts_cost) text += " :action-costs";
    return text;
  }

  std::string types() {
    std::string text;
    for (const PlanningType& type : task_.types) {
      if (type.name != "object") text += fmt::format(" {} - {}", types_.of(type.name), types_.of(type.parent));
    }
    if (!flat()) return text;
    for (const PlanningObject& object : task_.objects) types_.of(object.type);
    for (const PlanningOperator& op : task_.operators) {
      for (const PlanningParameter& parameter : op.parameters) types_.of(parameter.type);
    }
    for (const std::string& name : types_.all()) text += " " + name;
    return text;
  }

  static std::string declarations(const std::map<std::string, std::size_t>& declared) {
    std::string text;
    for (const auto& [name, arity] : declared) {
      text += "\n    (" + name;
      for (std::size_t i = 0; i < arity; ++i) text += fmt::format(" ?x{}", i);
      text += ")";
    }
    return text;
  }

  std::string domain() {
    const std::string functions =
        task_.counts_cost ? fmt::format("\n  (:functions\n    (total-cost){})", declarations(declared_functions_)) : "";
    return fmt::format("(define (domain pizarra)\n  (:requirements {})\n  (:types{}){}\n  (:predicates{}){}\n{})\n",
                       requirements(), types(), objects(true), declarations(declared_predicates_), functions, actions_);
  }

  const PlanningTask& task_;
  const bool names_objects_;
  PddlNames types_;
  PddlNames predicates_{{"and", "or", "not", "imply", "when", "exists", "forall", "increase"}};
  PddlNames functions_{{"total-cost"}};
  PddlNames objects_, operators_, variables_;
  std::map<std::string, std::size_t> declared_predicates_, declared_functions_;
  std::string actions_;
};

}  // namespace

PddlText pddl_text(const PlanningTask& task) { return PddlWriter(task).run(); }

}  // namespace pizarra::planner
