#include "lisp/forms/domain.hpp"

#include <algorithm>
#include <cassert>

#include "lisp/forms/domain_extension.hpp"
#include "lisp/forms/goal_formula.hpp"
#include "lisp/guile/module_errors.hpp"
#include "lisp/guile/scheme.hpp"

namespace pizarra::forms {

namespace {

std::vector<TypedName> typed_names(std::span<const Datum> pairs) {
  std::vector<TypedName> out;
  for (const Datum& pair : pairs) out.push_back({std::string(pair[0].text()), std::string(pair[1].text())});
  return out;
}

std::vector<Datum> data(const Datum& items) { return {items.items().begin(), items.items().end()}; }

std::vector<std::size_t> path(const Datum& indices) {
  std::vector<std::size_t> out;
  for (const Datum& index : indices.items()) out.push_back(static_cast<std::size_t>(index.integer()));
  return out;
}

// From the form that (pizarra strips) answers with.
Domain from_form(const Datum& form, Source source) {
  assert(form.is_form("domain") && form.size() == 11);
  Domain out;
  out.name = form[1].text();
  for (const Datum& type : form[2].items()) out.types.emplace_back(type.text());
  for (const Datum& predicate : form[3].items()) {
    out.predicates.push_back({std::string(predicate.head()), typed_names(predicate.items().subspan(1))});
  }
  out.objects = typed_names(form[4].items());
  out.facts = data(form[5]);
  for (const Datum& from : form[6].items()) {
    out.operators.push_back(
        {std::string(from.head()), typed_names(from[1].items()), data(from[2]), data(from[3]), data(from[4])});
  }
  out.perception = form[7];
  out.perception_path = path(form[8]);
  out.micro_tasks = form[9];
  out.micro_tasks_path = path(form[10]);
  out.source = std::move(source);
  return out;
}

}  // namespace

const Predicate* Domain::find_predicate(std::string_view predicate) const {
  const auto found = std::ranges::find(predicates, predicate, &Predicate::name);
  return found == predicates.end() ? nullptr : &*found;
}

const Operator* Domain::find_operator(std::string_view operator_name) const {
  const auto found = std::ranges::find(operators, operator_name, &Operator::name);
  return found == operators.end() ? nullptr : &*found;
}

Result<Domain> domain_from_source(Source source) {
  if (!source.errors().empty() && extends_another(source)) return fail(one_report(guile::failures_of(source)));
  Result<Source> whole = extended_domain(std::move(source));
  if (!whole) return fail(whole);
  const Result<Datum> form = guile::interpret(*whole, "strips");
  if (!form) return fail(form);
  return from_form(*form, std::move(*whole));
}

Result<Domain> read_domain(std::string_view text, std::string file) {
  Result<Source> source = read_source(text, std::move(file));
  if (!source) return fail(source);
  return domain_from_source(std::move(*source));
}

Result<Domain> read_domain_file(const std::string& path) {
  Result<Source> source = read_source_file(path);
  if (!source) return fail(source);
  return domain_from_source(std::move(*source));
}

Datum operator_form(const Operator& from) {
  std::vector<Datum> params{"params"_sym};
  for (const TypedName& param : from.params) {
    params.push_back(without_variables(list(Datum::symbol(param.name), Datum::symbol(param.type))));
  }
  std::vector<Datum> preconds{"preconds"_sym};
  for (const Datum& fact : from.preconds) preconds.push_back(without_variables(fact));
  std::vector<Datum> effects{"effects"_sym};
  for (const Datum& fact : from.adds) effects.push_back(without_variables(fact));
  for (const Datum& fact : from.deletes) effects.push_back(list("del"_sym, without_variables(fact)));
  return list("operator"_sym, Datum::symbol(from.name), Datum::list(std::move(params)),
              Datum::list(std::move(preconds)), Datum::list(std::move(effects)));
}

}  // namespace pizarra::forms
