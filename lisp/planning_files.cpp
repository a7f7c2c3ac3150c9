#include "lisp/planning_files.hpp"

#include <algorithm>

#include "lisp/domain.hpp"
#include "lisp/interpret.hpp"

namespace pizarra {

namespace {

constexpr ReadLimits limits{.bytes = 4 << 20, .depth = 64, .elements = 500'000};

bool is_pddl(const Source& source) {
  if (source.data().empty()) return false;
  const std::string_view head = source.data().front().head();
  return std::ranges::equal(head, std::string_view("define"), [](char a, char b) { return (a | 0x20) == b; });
}

std::string_view first_head(const Source& source) {
  return source.data().empty() ? std::string_view() : source.data().front().head();
}

Result<Source> in_lower_case_if_pddl(Result<Source> source) {
  if (!source || !is_pddl(*source)) return source;
  ReadLimits pddl = limits;
  pddl.lower_case = true;
  return read_source(source->text(), source->file(), pddl);
}

Datum typed(const TypedName& name) { return list(Datum::symbol(name.name), Datum::symbol(name.type)); }

template <class Items, class Make>
Datum list_of(const Items& items, const Make& make) {
  std::vector<Datum> out;
  for (const auto& item : items) out.push_back(make(item));
  return Datum::list(std::move(out));
}

// One of our own domains in the common form.
Datum form_of(const Domain& domain) {
  const Datum none;
  return list("domain"_sym, Datum::symbol(domain.name),
              list_of(domain.types, [](const std::string& type) { return list(Datum::symbol(type), "object"_sym); }),
              list_of(domain.objects, typed),
              list_of(domain.predicates,
                      [](const Predicate& predicate) {
                        std::vector<Datum> items{Datum::symbol(predicate.name)};
                        for (const TypedName& argument : predicate.arguments) {
                          items.push_back(Datum::symbol(argument.type));
                        }
                        return Datum::list(std::move(items));
                      }),
              none,
              list_of(domain.operators,
                      [&](const Operator& from) {
                        return list(Datum::symbol(from.name), list_of(from.params, typed), Datum::list(from.preconds),
                                    none, none, Datum::list(from.adds), Datum::list(from.deletes), none);
                      }),
              Datum::list(domain.facts));
}

Result<PlanningDomain> with_language(PlanningLanguage language, Result<Datum> form) {
  if (!form) return fail(form);
  return PlanningDomain{language, std::move(*form)};
}

}  // namespace

Result<Source> read_planning_source(std::string_view text, std::string file) {
  return in_lower_case_if_pddl(read_source(text, std::move(file), limits));
}

Result<Source> read_planning_source_file(const std::string& path) {
  return in_lower_case_if_pddl(read_source_file(path, limits));
}

Result<PlanningDomain> read_planning_domain(const Source& source) {
  if (is_pddl(source)) return with_language(PlanningLanguage::pddl, interpret(source, "pddl-domain"));
  if (first_head(source) == "operator") {
    return with_language(PlanningLanguage::operators, interpret(source, "planning-operators"));
  }
  if (first_head(source) == "domain") {
    const Result<Domain> domain = domain_from_source(source);
    if (!domain) return fail(domain);
    return PlanningDomain{PlanningLanguage::domain_file, form_of(*domain)};
  }
  return fail(source.failure_at({0}, "wrong-file",
                                "a domain begins with (define (domain ...) ...), (operator ...) or (domain ...)"));
}

Result<Datum> read_planning_problem(const Source& source, const PlanningDomain& domain) {
  const bool pddl = domain.language == PlanningLanguage::pddl;
  if (pddl != is_pddl(source)) {
    return fail(
        source.failure_at({0}, "wrong-file",
                          pddl ? "the domain is PDDL, so the problem must be: (define (problem ...) ...)"
                               : "the domain is not PDDL, so its facts are (types ...) (initials ...) (goals ...)"));
  }
  if (pddl) return interpret(source, "pddl-problem", {domain.form});
  const bool open = domain.language == PlanningLanguage::operators;
  return interpret(source, "planning-facts", {domain.form, open ? "open"_sym : "closed"_sym});
}

}  // namespace pizarra
