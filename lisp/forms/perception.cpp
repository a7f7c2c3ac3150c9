#include "lisp/forms/perception.hpp"

#include "lisp/guile/scheme.hpp"

namespace pizarra::forms {

Datum arities_to_datum(const Arities& arities) {
  std::vector<Datum> items;
  for (const auto& [name, arity] : arities) items.push_back(list(Datum::symbol(name), arity));
  return Datum::list(std::move(items));
}

Result<Perception> Perception::read(const Source& domain, const Arities& predicates) {
  const Result<Datum> read = guile::interpret(domain, "perception", {arities_to_datum(predicates)});
  if (!read) return fail(read);
  Perception perception;
  for (const Datum& part : read->items()) {
    if (part.is_form("section")) perception.keep(part[1]);
    if (part.is_form("sees")) perception.sees_ = part[1].text();
    if (part.is_form("constants")) {
      for (const Datum& constant : part.items().subspan(1)) {
        perception.constants_.insert_or_assign(std::string(constant[0].text()), constant[1].number());
      }
    }
    if (part.is_form("facts")) perception.facts_.assign(part.items().begin() + 1, part.items().end());
  }
  return perception;
}

Result<std::vector<Datum>> Perception::perceive(const std::vector<Datum>& measured,
                                                const std::vector<Datum>& believed) const {
  const std::vector<Datum> arguments{number_, Datum::list(measured), Datum::list(believed)};
  const Result<Datum> outcome = guile::call_scheme("perceive", "perceive", arguments);
  if (!outcome) return fail(outcome);
  return found_facts(*outcome);
}

Result<std::vector<Datum>> found_facts(const Datum& outcome) {
  if (outcome.is_form("fail")) return fail(failure_from_datum(outcome));
  const Datum& facts = outcome[1];
  return std::vector<Datum>(facts.items().begin(), facts.items().end());
}

void Perception::keep(Datum section) {
  section_ = std::move(section);
  // What is checked can be compiled; the section itself does where it cannot.
  number_ = guile::call_scheme("perceive", "section-number", {section_}).value_or(section_);
}

void Perception::set_constant(std::string_view name, double value) {
  const auto known = constants_.find(name);
  if (known == constants_.end() || known->second == value) return;
  known->second = value;
  std::vector<Datum> parts;
  for (const Datum& part : section_.items()) {
    const bool meant = part.is_form("constant") && part[1].is_symbol(name);
    parts.push_back(meant ? list("constant"_sym, Datum::symbol(name), value) : part);
  }
  keep(Datum::list(std::move(parts)));
}

void Perception::set_edges(const EdgesMm& edges) {
  std::vector<Datum> parts(section_.items().begin(), section_.items().end());
  for (const auto& [name, edge_mm] : edges) {
    facts_.push_back(list("edge"_sym, Datum::symbol(name), edge_mm));
    parts.push_back(list("fact"_sym, facts_.back()));
  }
  keep(Datum::list(std::move(parts)));
}

std::optional<double> Perception::constant(std::string_view name) const {
  const auto it = constants_.find(name);
  if (it == constants_.end()) return std::nullopt;
  return it->second;
}

}  // namespace pizarra::forms
