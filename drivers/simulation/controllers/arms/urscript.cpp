#include "drivers/simulation/controllers/arms/urscript.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "drivers/line/printable.hpp"
#include "lisp/plain_text.hpp"

namespace pizarra::simulation {

namespace {

constexpr std::size_t most_program_steps = 10'000;

// Takes a number off the front; what separates it from the next goes too.
std::optional<double> take_number(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(" ,"), text.size()));
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

// The arguments of a call, cut at commas outside of brackets.
std::vector<std::string_view> arguments_in(std::string_view text) {
  std::vector<std::string_view> arguments;
  int depth = 0;
  std::size_t begin = 0;
  for (std::size_t at = 0; at <= text.size(); ++at) {
    if (at < text.size() && (text[at] == '[' || text[at] == '(')) ++depth;
    if (at < text.size() && (text[at] == ']' || text[at] == ')')) --depth;
    if (at < text.size() && (text[at] != ',' || depth != 0)) continue;
    const std::string_view argument = trimmed(text.substr(begin, at - begin));
    if (!argument.empty()) arguments.push_back(argument);
    begin = at + 1;
  }
  return arguments;
}

// All of the text is one number, or a truth.
std::optional<double> number_of(std::string_view text) {
  if (text == "True" || text == "False") return text == "True" ? 1 : 0;
  const std::optional<double> value = take_number(text);
  return value && trimmed(text).empty() ? value : std::nullopt;
}

// Six numbers in brackets, with p before them where they are a pose.
bool read_target(std::string_view text, UrStep& step) {
  step.pose = text.starts_with('p');
  if (step.pose) text.remove_prefix(1);
  if (!text.starts_with('[') || !text.ends_with(']')) return false;
  const std::vector<std::string_view> numbers = arguments_in(text.substr(1, text.size() - 2));
  if (numbers.size() != step.target.size()) return false;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::optional<double> value = number_of(numbers[i]);
    if (!value) return false;
    step.target[i] = *value;
  }
  return true;
}

// A target, then acceleration, speed, time and radius, by their places or their names.
std::optional<UrStep> move_step(UrStep::Kind kind, const std::vector<std::string_view>& arguments) {
  constexpr std::string_view names[] = {"a", "v", "t", "r"};
  UrStep step{.kind = kind, .speed = kind == UrStep::Kind::move_line ? 0.25 : 1.05};
  if (arguments.empty() || arguments.size() > 1 + std::size(names) || !read_target(arguments[0], step)) {
    return std::nullopt;
  }
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    const std::size_t equals = arguments[i].find('=');
    const bool named = equals != std::string_view::npos;
    const std::string_view name = named ? trimmed(arguments[i].substr(0, equals)) : names[i - 1];
    const std::optional<double> value = number_of(named ? trimmed(arguments[i].substr(equals + 1)) : arguments[i]);
    if (!value || std::ranges::find(names, name) == std::end(names)) return std::nullopt;
    if (name == "v" && *value <= 0) return std::nullopt;
    if (name == "t" && *value < 0) return std::nullopt;
    if (name == "v") step.speed = *value;
    if (name == "t") step.time_s = *value;
  }
  return step;
}

// A register or an output: its number and what it is set to.
std::optional<UrStep> setting_step(std::string_view name, const std::vector<std::string_view>& arguments) {
  struct Setting {
    std::string_view name;
    std::string_view field;  // of a register
    int count;
  };
  constexpr Setting settings[] = {{"write_output_integer_register", "output_int_register_", 48},
                                  {"write_output_float_register", "output_double_register_", 48},
                                  {"write_output_boolean_register", "output_bit_register_", 128},
                                  {"set_digital_out", "", 10},
                                  {"set_standard_digital_out", "", 8},
                                  {"set_configurable_digital_out", "", 8},
                                  {"set_tool_digital_out", "", 2}};
  const auto* found = std::ranges::find(settings, name, &Setting::name);
  if (found == std::end(settings) || arguments.size() != 2) return std::nullopt;
  const std::optional<double> number = number_of(arguments[0]);
  const std::optional<double> value = number_of(arguments[1]);
  if (!number || !value || *number < 0 || *number >= found->count || std::abs(*value) > 2e9) return std::nullopt;
  // The outputs of a UR: 8 of its own, 8 that can be configured, 2 of its tool.
  const int first = name == "set_configurable_digital_out" ? 8 : name == "set_tool_digital_out" ? 16 : 0;
  UrStep step{.kind = found->field.empty() ? UrStep::Kind::digital_output : UrStep::Kind::set};
  step.number = first + static_cast<int>(*number);
  step.value = *value;
  step.field = std::string(found->field) + std::to_string(step.number);
  return step;
}

// What it says, without its quotes.
UrStep text_step(std::string_view arguments) {
  UrStep step{.kind = UrStep::Kind::text};
  for (const char c : arguments) {
    if (c != '"') step.field += c;
  }
  return step;
}

std::optional<UrStep> step_of(std::string_view line) {
  const std::size_t open = line.find('(');
  if (open == std::string_view::npos || !line.ends_with(')')) return std::nullopt;
  const std::string_view name = trimmed(line.substr(0, open));
  const std::vector<std::string_view> arguments = arguments_in(line.substr(open + 1, line.size() - open - 2));
  if (name == "movej") return move_step(UrStep::Kind::move_joints, arguments);
  if (name == "movel") return move_step(UrStep::Kind::move_line, arguments);
  if (name == "textmsg") return text_step(line.substr(open + 1, line.size() - open - 2));
  constexpr std::string_view idle[] = {"popup", "set_tcp", "set_payload", "set_gravity", "sync"};
  if (std::ranges::find(idle, name) != std::end(idle)) return UrStep{.kind = UrStep::Kind::nothing};
  const bool takes_number = name == "stopj" || name == "stopl" || name == "sleep";
  if (!takes_number) return setting_step(name, arguments);
  const std::optional<double> number = arguments.empty() ? std::nullopt : number_of(arguments[0]);
  if (!number || *number < 0) return std::nullopt;
  return UrStep{.kind = name == "sleep" ? UrStep::Kind::sleep : UrStep::Kind::stop, .value = *number};
}

}  // namespace

Result<std::vector<UrStep>> read_urscript(std::string_view program) {
  std::vector<UrStep> steps;
  for (std::int32_t number = 1; !program.empty(); ++number) {
    const std::size_t end = std::min(program.find('\n'), program.size());
    const std::string_view line = trimmed(program.substr(0, end));
    program.remove_prefix(std::min(end + 1, program.size()));
    if (line.empty() || line.starts_with('#') || line.starts_with("def ") || line.starts_with("sec ") ||
        line == "end") {
      continue;
    }
    const std::optional<UrStep> step = step_of(line);
    if (!step || steps.size() >= most_program_steps) {
      return fail("bad-script", "the controller does not understand " + line::printable(line), to_datum(number));
    }
    steps.push_back(*step);
  }
  return steps;
}

}  // namespace pizarra::simulation
