#include "lisp/guile/interpret.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "lisp/guile/scheme.hpp"

namespace pizarra::guile {

namespace {

bool is_error(const Datum& error) {
  return error.size() == 4 && error[0].is_symbol() && error[1].is_string() && error[2].is_list() && error[3].is_list();
}

std::vector<std::size_t> path_of(const Datum& error) {
  std::vector<std::size_t> path;
  for (const Datum& index : error[2].items()) path.push_back(static_cast<std::size_t>(index.integer()));
  return path;
}

Failure locate(const Source& source, const Datum& error) {
  std::vector<std::string> context;
  for (const Datum& line : error[3].items()) context.emplace_back(line.text());
  return source.failure_at(path_of(error), std::string(error[0].text()), std::string(error[1].text()), context);
}

// The element that a path leads to; () where there is none.
Datum element_at(std::span<const Datum> elements, const std::vector<std::size_t>& path) {
  Datum element;
  for (const std::size_t index : path) {
    if (index >= elements.size()) return {};
    element = elements[index];
    elements = element.items();
  }
  return element;
}

std::unexpected<std::vector<Failure>> alone(Failure failure) {
  return std::unexpected(std::vector<Failure>{std::move(failure)});
}

// What the module answers: (ok VALUE) or (errors ERROR ...).
Result<Datum> outcome_of(const std::vector<Datum>& data, const std::string& module, const std::vector<Datum>& more,
                         const std::string& procedure) {
  std::vector<Datum> arguments{Datum::list(data)};
  arguments.insert(arguments.end(), more.begin(), more.end());
  Result<Datum> outcome = call_scheme(module, procedure, arguments);
  if (!outcome) return outcome;
  const bool ok = outcome->is_form("ok") && outcome->size() == 2;
  const auto errors = outcome->items().subspan(std::min<std::size_t>(outcome->size(), 1));
  const bool refused = outcome->is_form("errors") && !errors.empty() && std::ranges::all_of(errors, is_error);
  if (ok || refused) return outcome;
  return fail("scheme-error", fmt::format("(pizarra {}) {} returned no outcome", module, procedure), *outcome);
}

// Behind the name or number that begins there; of a list, behind its parenthesis.
std::size_t end_of_atom(const Source& source, std::size_t offset) {
  return std::max(offset + 1, std::min(source.text().find_first_of(" \t\r\n();\"", offset), source.text().size()));
}

}  // namespace

// A place that could not be read gets no second error.
std::vector<Failure> failures_of(const Source& source, std::span<const Datum> errors) {
  std::vector<Failure> failures;
  auto unread = source.errors().begin();
  for (const Datum& error : errors) {
    const std::size_t offset = source.offset_at(path_of(error));
    for (; unread != source.errors().end() && unread->offset < offset; ++unread) {
      failures.push_back(source.failure_of(*unread));
    }
    const bool said = unread != source.errors().end() && unread->offset < end_of_atom(source, offset);
    if (!said) failures.push_back(locate(source, error));
  }
  for (; unread != source.errors().end(); ++unread) failures.push_back(source.failure_of(*unread));
  return failures;
}

std::expected<Datum, std::vector<Failure>> interpret_apart(const Source& source, const std::string& module,
                                                           const std::vector<Datum>& more,
                                                           const std::string& procedure) {
  const Result<Datum> outcome = outcome_of(source.data(), module, more, procedure);
  if (!outcome) return alone(outcome.error());
  if (outcome->is_form("errors")) return std::unexpected(failures_of(source, outcome->items().subspan(1)));
  if (!source.errors().empty()) return std::unexpected(failures_of(source, {}));
  return (*outcome)[1];
}

Result<Datum> interpret_data(const std::vector<Datum>& data, const std::string& module,
                             const std::vector<Datum>& more) {
  const Result<Datum> outcome = outcome_of(data, module, more, "interpret");
  if (!outcome) return fail(outcome);
  if (outcome->is_form("ok")) return (*outcome)[1];
  const Datum& first = (*outcome)[1];
  return fail(std::string(first[0].text()), std::string(first[1].text()), element_at(data, path_of(first)));
}

Result<Datum> interpret(const Source& source, const std::string& module, const std::vector<Datum>& more,
                        const std::string& procedure) {
  std::expected<Datum, std::vector<Failure>> read = interpret_apart(source, module, more, procedure);
  if (!read) return fail(one_report(read.error()));
  return std::move(*read);
}

}  // namespace pizarra::guile
