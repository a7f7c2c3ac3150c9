#include "drivers/simulation/controllers/arms/urscript.hpp"

#include <charconv>
#include <cmath>
#include <optional>

#include "drivers/line/printable.hpp"

namespace pizarra::simulation {

namespace {

constexpr std::size_t most_program_steps = 10'000;

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

// Takes a number off the front; what separates it from the next goes too.
std::optional<double> take_number(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(" ,"), text.size()));
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

// The value of `name=` among the arguments.
std::optional<double> named(std::string_view arguments, std::string_view name) {
  const std::size_t at = arguments.find(name);
  if (at == std::string_view::npos) return std::nullopt;
  arguments.remove_prefix(at + name.size());
  return take_number(arguments);
}

std::optional<UrStep> move_step(UrStep::Kind kind, std::string_view arguments) {
  if (!arguments.starts_with('[')) return std::nullopt;
  arguments.remove_prefix(1);
  UrStep step{.kind = kind};
  for (double& joint : step.joints_rad) {
    const std::optional<double> value = take_number(arguments);
    if (!value) return std::nullopt;
    joint = *value;
  }
  if (!arguments.starts_with(']')) return std::nullopt;
  const std::optional<double> speed = named(arguments, "v=");
  if (speed && *speed <= 0) return std::nullopt;
  step.speed = speed.value_or(kind == UrStep::Kind::move_line ? 0.25 : 1.05);
  return step;
}

std::optional<UrStep> step_of(std::string_view line) {
  const std::size_t open = line.find('(');
  if (open == std::string_view::npos || !line.ends_with(')')) return std::nullopt;
  const std::string_view name = line.substr(0, open);
  std::string_view arguments = line.substr(open + 1, line.size() - open - 2);
  if (name == "movej") return move_step(UrStep::Kind::move_joints, arguments);
  if (name == "movel") return move_step(UrStep::Kind::move_line, arguments);
  const std::optional<double> first = take_number(arguments);
  if (!first) return std::nullopt;
  if (name == "stopj") return UrStep{.kind = UrStep::Kind::stop};
  if (name == "sleep") return UrStep{.kind = UrStep::Kind::sleep, .value = *first};
  if (name != "write_output_integer_register") return std::nullopt;
  const std::optional<double> value = take_number(arguments);
  constexpr double registers = 48;
  if (!value || *first < 0 || *first >= registers || std::abs(*value) > 2e9) return std::nullopt;
  return UrStep{.kind = UrStep::Kind::write_register, .number = static_cast<int>(*first), .value = *value};
}

}  // namespace

Result<std::vector<UrStep>> read_urscript(std::string_view program) {
  std::vector<UrStep> steps;
  while (!program.empty()) {
    const std::size_t end = std::min(program.find('\n'), program.size());
    const std::string_view line = trimmed(program.substr(0, end));
    program.remove_prefix(std::min(end + 1, program.size()));
    if (line.empty() || line.starts_with('#') || line.starts_with("def ") || line == "end") continue;
    const std::optional<UrStep> step = step_of(line);
    if (!step || steps.size() >= most_program_steps) {
      return fail("bad-script", "the controller does not understand " + line::printable(line));
    }
    steps.push_back(*step);
  }
  return steps;
}

}  // namespace pizarra::simulation
