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

// What stands in nothing, or in (define ...) alone.
std::optional<std::size_t> depth_of_form(std::string_view name) {
  constexpr std::string_view outermost[] = {"define", "operator", "types", "initials", "goals"};
  constexpr std::string_view sections[] = {":requirements", ":types",  ":constants", ":predicates",
                                           ":functions",    ":action", ":domain",    ":objects",
                                           ":init",         ":goal",   ":metric"};
  const auto is_name = [&](std::string_view other) {
    return std::ranges::equal(name, other, [](char a, char b) { return a == b || (a | 0x20) == b; });
  };
  if (std::ranges::any_of(outermost, is_name)) return 0;
  if (std::ranges::any_of(sections, is_name)) return 1;
  return std::nullopt;
}

// One of our own domain files has sections (types ...) inside.
std::optional<std::size_t> any_depth(std::string_view) { return std::nullopt; }

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

std::unexpected<Failure> wrong_file(const Source& source, std::string sentence) {
  if (!source.errors().empty()) return fail(report_errors(source, {}));
  return fail(source.failure_at({0}, "wrong-file", std::move(sentence)));
}

enum class FileKind : std::uint8_t { domain, problem, other };

FileKind kind_of(const Source& source) {
  constexpr std::string_view problems[] = {"types", "initials", "goals", "preconds", "effects"};
  const std::string_view head = first_head(source);
  if (head == "operator" || head == "domain") return FileKind::domain;
  if (std::ranges::find(problems, head) != std::end(problems)) return FileKind::problem;
  if (!is_pddl(source) || source.data().front().size() < 2) return FileKind::other;
  const Datum& named = source.data().front()[1];
  if (named.is_form("problem")) return FileKind::problem;
  return named.is_form("domain") ? FileKind::domain : FileKind::other;
}

Result<PlanningDomain> read_pddl_domain(const Source& source) {
  Result<Datum> form = interpret(source, "pddl-domain");
  if (!form) return fail(form);
  return PlanningDomain{PlanningLanguage::pddl, std::move(*form), {}};
}

// Where the facts are not all readable, objects may be missing that are there.
bool tells_objects(const Source& facts) {
  return kind_of(facts) == FileKind::problem && !is_pddl(facts) && facts.errors().empty();
}

std::vector<Datum> fitting(const Source* facts) {
  if (facts == nullptr || !tells_objects(*facts)) return {};
  return {Datum::list(facts->data())};
}

Result<PlanningDomain> read_operators(const Source& source, const Source* facts) {
  Result<Datum> form = interpret(source, "planning-operators");
  if (!form) return fail(interpret(source, "planning-operators", fitting(facts)));
  return PlanningDomain{PlanningLanguage::operators, std::move(*form), source};
}

Result<Datum> read_facts(const Source& source, const PlanningDomain& domain) {
  const bool open = domain.language == PlanningLanguage::operators;
  const auto facts = interpret_apart(source, "planning-facts", {domain.form, open ? "open"_sym : "closed"_sym});
  std::vector<Failure> wrong;
  if (domain.operators) {
    const auto operators = interpret_apart(*domain.operators, "planning-operators", fitting(&source));
    if (!operators) wrong = operators.error();
  }
  if (!facts) wrong.insert(wrong.end(), facts.error().begin(), facts.error().end());
  if (!wrong.empty()) return fail(one_report(wrong));
  return *facts;
}

}  // namespace

Result<Source> read_planning_source(std::string_view text, std::string file) {
  const bool domain_file = text.find("(domain") < text.find("(define");
  Result<Source> source = read_source_to_the_end(text, file, limits, domain_file ? any_depth : depth_of_form);
  if (!source || !is_pddl(*source)) return source;
  ReadLimits pddl = limits;
  pddl.lower_case = true;
  return read_source_to_the_end(text, std::move(file), pddl, depth_of_form);
}

Result<Source> read_planning_source_file(const std::string& path) {
  const Result<std::string> text = read_text_file(path, limits);
  if (!text) return fail(text);
  return read_planning_source(*text, path);
}

Result<PlanningDomain> read_planning_domain(const Source& source, const Source* facts) {
  if (kind_of(source) == FileKind::problem) {
    return wrong_file(source, "this is a problem; the domain must be named first, and it second");
  }
  if (is_pddl(source)) return read_pddl_domain(source);
  if (first_head(source) == "operator") return read_operators(source, facts);
  if (first_head(source) == "domain") {
    const Result<Domain> domain = domain_from_source(source);
    if (!domain) return fail(domain);
    return PlanningDomain{PlanningLanguage::domain_file, form_of(*domain), {}};
  }
  return wrong_file(source, "a domain begins with (define (domain ...) ...), (operator ...) or (domain ...)");
}

Result<Datum> read_planning_problem(const Source& source, const PlanningDomain& domain) {
  if (kind_of(source) == FileKind::domain) return wrong_file(source, "this is a domain; a problem must stand here");
  const bool pddl = domain.language == PlanningLanguage::pddl;
  if (pddl != is_pddl(source)) {
    return wrong_file(source, pddl ? "the domain is PDDL, so the problem must be: (define (problem ...) ...)"
                                   : "the domain is not PDDL, so its facts are (types ...) (initials ...) (goals ...)");
  }
  if (pddl) return interpret(source, "pddl-problem", {domain.form});
  return read_facts(source, domain);
}

}  // namespace pizarra
