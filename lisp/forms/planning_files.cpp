#include "lisp/forms/planning_files.hpp"

#include <algorithm>

#include "lisp/forms/domain.hpp"
#include "lisp/guile/module_errors.hpp"
#include "lisp/guile/scheme.hpp"

namespace pizarra::forms {

namespace {

constexpr ReadLimits file_limits{.bytes = 4 << 20, .depth = 64, .elements = 500'000};

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

Datum typed_form(const TypedName& name) { return list(Datum::symbol(name.name), Datum::symbol(name.type)); }

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
              list_of(domain.objects, typed_form),
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
                        return list(Datum::symbol(from.name), list_of(from.params, typed_form),
                                    Datum::list(from.preconds), none, none, Datum::list(from.adds),
                                    Datum::list(from.deletes), none);
                      }),
              Datum::list(domain.facts));
}

// What was read, or every error of its own.
template <class T>
using Read = std::expected<T, std::vector<Failure>>;

std::vector<Failure> joined(std::vector<Failure> failures, const std::vector<Failure>& more) {
  failures.insert(failures.end(), more.begin(), more.end());
  return failures;
}

std::unexpected<std::vector<Failure>> wrong_file(const Source& source, std::string sentence) {
  if (!source.errors().empty()) return std::unexpected(guile::failures_of(source));
  if (source.data().empty()) sentence = "nothing is written here; " + sentence;
  return std::unexpected(std::vector{source.failure_at({0}, "wrong-file", std::move(sentence))});
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

// Where the facts are not all readable, objects may be missing that are there.
bool tells_objects(const Source& facts) {
  return kind_of(facts) == FileKind::problem && !is_pddl(facts) && facts.errors().empty();
}

Read<PlanningDomain> read_operators(const Source& source, const Source* facts) {
  std::vector<Datum> fitting;
  if (facts != nullptr && tells_objects(*facts)) fitting = {Datum::list(facts->data())};
  Read<Datum> form = guile::interpret_apart(source, "planning-operators", fitting);
  if (!form) return std::unexpected(form.error());
  return PlanningDomain{PlanningLanguage::operators, std::move(*form), source};
}

Read<PlanningDomain> read_domain(const Source& source, const Source* problem) {
  if (kind_of(source) == FileKind::problem) {
    return wrong_file(source, "this is a problem; the domain must be named first, and it second");
  }
  if (is_pddl(source)) {
    Read<Datum> form = guile::interpret_apart(source, "pddl-domain");
    if (!form) return std::unexpected(form.error());
    return PlanningDomain{PlanningLanguage::pddl, std::move(*form), {}};
  }
  if (first_head(source) == "operator") return read_operators(source, problem);
  if (first_head(source) == "domain") {
    const Result<Domain> domain = domain_from_source(source);
    if (!domain) return std::unexpected(std::vector{domain.error()});
    return PlanningDomain{PlanningLanguage::domain_file, form_of(*domain), {}};
  }
  return wrong_file(source, "a domain begins with (define (domain ...) ...), (operator ...) or (domain ...)");
}

// Why the file cannot be a problem of a domain in PDDL, or not in PDDL; nothing where it can.
std::vector<Failure> misfit(const Source& source, bool pddl) {
  if (kind_of(source) == FileKind::domain)
    return wrong_file(source, "this is a domain; a problem must stand here").error();
  if (pddl == is_pddl(source)) return {};
  return wrong_file(source, pddl ? "the domain is PDDL, so the problem must be: (define (problem ...) ...)"
                                 : "the domain is not PDDL, so its facts are (types ...) (initials ...) (goals ...)")
      .error();
}

Read<Datum> read_problem(const Source& source, const PlanningDomain& domain) {
  const bool pddl = domain.language == PlanningLanguage::pddl;
  std::vector<Failure> unfit = misfit(source, pddl);
  if (!unfit.empty()) return std::unexpected(std::move(unfit));
  if (pddl) return guile::interpret_apart(source, "pddl-problem", {domain.form});
  const bool open = domain.language == PlanningLanguage::operators;
  Read<Datum> facts = guile::interpret_apart(source, "planning-facts", {domain.form, open ? "open"_sym : "closed"_sym});
  if (!domain.operators) return facts;
  const Read<PlanningDomain> operators = read_operators(*domain.operators, &source);
  if (operators) return facts;
  return std::unexpected(joined(operators.error(), facts ? std::vector<Failure>() : facts.error()));
}

// The problem's faults, as far as its domain, which is wrong too, can be understood.
std::vector<Failure> wrong_beside(const Source& source, const Source& domain) {
  if (kind_of(domain) != FileKind::domain) return {};
  std::vector<Failure> unfit = misfit(source, is_pddl(domain));
  if (!unfit.empty()) return unfit;
  if (first_head(domain) == "domain") return guile::failures_of(source);
  const std::string module = is_pddl(domain) ? "pddl-problem" : "planning-operators";
  const Read<Datum> read = guile::interpret_apart(source, module, {Datum::list(domain.data())}, "interpret-beside");
  return read ? std::vector<Failure>() : read.error();
}

template <class T>
Result<T> reported(Read<T> read) {
  if (!read) return fail(one_report(read.error()));
  return std::move(*read);
}

}  // namespace

Result<Source> read_planning_source(std::string_view text, std::string file) {
  const bool domain_file = text.find("(domain") < text.find("(define");
  Result<Source> source = read_source_to_the_end(text, file, file_limits, domain_file ? any_depth : depth_of_form);
  if (!source || !is_pddl(*source)) return source;
  ReadLimits pddl = file_limits;
  pddl.lower_case = true;
  return read_source_to_the_end(text, std::move(file), pddl, depth_of_form);
}

Result<Source> read_planning_source_file(const std::string& path) {
  const Result<std::string> text = read_text_file(path, file_limits);
  if (!text) return fail(text);
  return read_planning_source(*text, path);
}

Result<PlanningDomain> read_planning_domain(const Source& source, const Source* facts) {
  return reported(read_domain(source, facts));
}

Result<Datum> read_planning_problem(const Source& source, const PlanningDomain& domain) {
  return reported(read_problem(source, domain));
}

Result<void> check_planning_problem(const Source& source, const Source& domain) {
  const std::vector<Failure> failures = wrong_beside(source, domain);
  if (!failures.empty()) return fail(one_report(failures));
  return {};
}

Result<PlanningFiles> read_planning_files(const Source& domain, const Source& problem) {
  Read<PlanningDomain> read = read_domain(domain, &problem);
  if (!read) return fail(one_report(joined(read.error(), wrong_beside(problem, domain))));
  read->operators.reset();  // they fit the problem
  Read<Datum> form = read_problem(problem, *read);
  if (!form) return fail(one_report(form.error()));
  return PlanningFiles{std::move(*read), std::move(*form)};
}

}  // namespace pizarra::forms
