#include "lisp/interpret.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "lisp/scheme.hpp"

namespace pizarra {

namespace {

constexpr std::size_t max_reported = 20;

bool is_error(const Datum& error) {
  return error.size() == 4 && error[0].is_symbol() && error[1].is_string() && error[2].is_list() && error[3].is_list();
}

Failure locate(const Source& source, const Datum& error) {
  std::vector<std::size_t> path;
  for (const Datum& index : error[2].items()) path.push_back(static_cast<std::size_t>(index.integer()));
  std::vector<std::string> context;
  for (const Datum& line : error[3].items()) context.emplace_back(line.text());
  return source.failure_at(path, std::string(error[0].text()), std::string(error[1].text()), context);
}

}  // namespace

Failure report_errors(const Source& source, std::span<const Datum> errors) {
  Failure out = locate(source, errors.front());
  if (errors.size() > 1) out.sentence += fmt::format(" (and {} more)", errors.size() - 1);
  const std::size_t reported = std::min(errors.size(), max_reported);
  for (const Datum& error : errors.subspan(1, reported - 1)) {
    const Failure more = locate(source, error);
    out.place += '\n' + more.sentence + '\n' + more.place;
  }
  if (reported < errors.size()) out.place += fmt::format("\nand {} more", errors.size() - reported);
  return out;
}

Result<Datum> interpret(const Source& source, const std::string& module, const std::vector<Datum>& more,
                        const std::string& procedure) {
  std::vector<Datum> arguments{Datum::list(source.data())};
  arguments.insert(arguments.end(), more.begin(), more.end());
  Result<Datum> outcome = call_scheme(module, procedure, arguments);
  if (!outcome) return outcome;
  if (outcome->is_form("ok") && outcome->size() == 2) return (*outcome)[1];
  const auto errors = outcome->items().subspan(std::min<std::size_t>(outcome->size(), 1));
  if (!outcome->is_form("errors") || errors.empty() || !std::ranges::all_of(errors, is_error)) {
    return fail("scheme-error", fmt::format("(pizarra {}) {} returned no outcome", module, procedure), *outcome);
  }
  return fail(report_errors(source, errors));
}

}  // namespace pizarra
