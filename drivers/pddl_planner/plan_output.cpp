#include "drivers/pddl_planner/plan_output.hpp"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <optional>

#include "lisp/plain_text.hpp"

namespace pizarra::pddl_planner {

namespace {

// The names between blanks and commas, in lower case.
std::vector<std::string> names_in(std::string_view text) {
  std::vector<std::string> names;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of(" \t\r\f\v,"), text.size());
    if (end > 0) names.push_back(lowered(text.substr(0, end)));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return names;
}

struct Line {
  std::optional<double> number;  // of its step
  std::string_view text;
};

// Without comment, the word `step` and the number before a colon.
Line line_of(std::string_view text) {
  Line line{.number = {}, .text = trimmed(text.substr(0, text.find(';')))};
  std::string_view rest = line.text;
  constexpr std::string_view step = "step";
  if (rest.size() > step.size() && lowered(rest.substr(0, step.size())) == step) {
    rest = trimmed(rest.substr(step.size()));
  }
  double number = 0;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
  const auto length = static_cast<std::size_t>(end - rest.data());
  if (error != std::errc() || length >= rest.size() || rest[length] != ':') return line;
  return {number, trimmed(rest.substr(length + 1))};
}

// name(a,b) name(c) ...
PlanActions calls_in(std::string_view text) {
  PlanActions actions;
  while (!text.empty()) {
    const std::size_t open = text.find('(');
    const std::size_t close = text.find(')');
    if (open == std::string_view::npos || close == std::string_view::npos || close < open) return {};
    std::vector<std::string> action = names_in(text.substr(0, open));
    if (action.size() != 1) return {};
    for (std::string& name : names_in(text.substr(open + 1, close - open - 1))) action.push_back(std::move(name));
    actions.push_back(std::move(action));
    text = trimmed(text.substr(close + 1));
  }
  return actions;
}

// What the line says, known or not.
PlanActions actions_on(const Line& line) {
  if (line.text.starts_with('(')) return {names_in(line.text.substr(1, line.text.find(')') - 1))};
  const std::size_t open = line.text.find('(');
  const bool is_call = open != std::string_view::npos && open > 0 && blanks.find(line.text[open - 1]) == blanks.npos;
  if (is_call) return calls_in(line.text);
  const bool ends_with_cost = open != std::string_view::npos && line.text.ends_with(')');
  if (line.number || ends_with_cost) return {names_in(line.text.substr(0, open))};
  return {};
}

bool all_known(const PlanActions& actions, const PlanOperators& operators) {
  return !actions.empty() && std::ranges::all_of(actions, [&](const std::vector<std::string>& action) {
    const auto known = action.empty() ? operators.end() : operators.find(action.front());
    return known != operators.end() && known->second == action.size() - 1;
  });
}

// Line after line; `visit` answers whether to go on.
template <class Visit>
void each_line(std::string_view text, Visit visit) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    if (!visit(line_of(text.substr(0, end)))) return;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

}  // namespace

PlanActions find_actions(std::string_view text, const PlanOperators& operators) {
  PlanActions found;
  double last_number = 0;
  each_line(text, [&](const Line& line) {
    const PlanActions actions = actions_on(line);
    if (!all_known(actions, operators)) return true;
    if (line.number && *line.number == 0 && last_number > 0) found.clear();
    last_number = line.number.value_or(last_number);
    found.insert(found.end(), actions.begin(), actions.end());
    return true;
  });
  return found;
}

Result<PlanActions> read_actions(std::string_view text, const PlanOperators& operators) {
  PlanActions found;
  Result<PlanActions> outcome = PlanActions();
  each_line(text, [&](const Line& line) {
    if (line.text.empty()) return true;
    const PlanActions actions = actions_on(line);
    if (all_known(actions, operators)) {
      found.insert(found.end(), actions.begin(), actions.end());
      return true;
    }
    outcome = fail("garbage", fmt::format("its plan has a line that is no action: {}", line.text.substr(0, 80)));
    return false;
  });
  if (!outcome) return outcome;
  return found;
}

}  // namespace pizarra::pddl_planner
