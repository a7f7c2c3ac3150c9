#include "blackboard/store/narrowing.hpp"

#include <algorithm>

#include "lisp/pattern.hpp"

namespace pizarra::store {

namespace {

// Keeps the part of the range in which the comparison NAME with the value holds.
void narrow(ValueRange& range, std::string_view name, const Datum& value) {
  if (name == "=" || name == ">" || name == ">=") range.begin_at(value, name != ">");
  if (name == "=" || name == "<" || name == "<=") range.end_at(value, name != "<");
}

std::string_view turned_round(std::string_view name) {
  if (name == "<") return ">";
  if (name == "<=") return ">=";
  if (name == ">") return "<";
  if (name == ">=") return "<=";
  return name;
}

}  // namespace

std::optional<std::size_t> argument_of(const Datum& variable, const Datum& pattern) {
  const auto arguments = pattern.items().subspan(1);
  const auto found = std::ranges::find(arguments, variable);
  if (found == arguments.end()) return std::nullopt;
  return static_cast<std::size_t>(found - arguments.begin());
}

void narrow(std::vector<ValueRange>& ranges, const Datum& pattern, const Datum& comparison) {
  if (comparison.is_form("/=")) return;
  for (const bool turned : {false, true}) {
    const Datum& variable = comparison[turned ? 2 : 1];
    const Datum& value = comparison[turned ? 1 : 2];
    const std::optional<std::size_t> argument = argument_of(variable, pattern);
    if (!is_variable(variable) || !is_ground(value) || !argument) continue;
    auto range = std::ranges::find(ranges, *argument, &ValueRange::argument);
    if (range == ranges.end()) range = ranges.insert(range, ValueRange{.argument = *argument});
    narrow(*range, turned ? turned_round(comparison.head()) : comparison.head(), value);
  }
}

}  // namespace pizarra::store
