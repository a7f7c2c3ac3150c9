#include "agents/repl/answer_text.hpp"

#include <fmt/format.h>

#include "lisp/writer.hpp"

namespace pizarra::repl {

namespace {

template <class Items, class Write>
std::string joined(const Items& items, Write write_item) {
  std::string out;
  for (const auto& item : items) out += (out.empty() ? "" : ",") + write_item(item);
  return out;
}

}  // namespace

std::string bindings_text(const Answer& answer) {
  if (answer.bindings.all().empty()) return "yes";
  std::string text;
  for (const auto& [variable, value] : answer.bindings.all()) {
    text += fmt::format("{}{} = {}", text.empty() ? "" : "  ", variable.text(), write(value));
  }
  return text;
}

std::string json_answer(const Answer& answer) {
  const std::string bindings = joined(answer.bindings.all(), [](const auto& binding) {
    return fmt::format("{}:{}", json_string(binding.variable.text()), json_string(write(binding.value)));
  });
  const std::string facts = joined(answer.facts, [](const Fact& fact) { return json_string(write(fact.datum)); });
  return fmt::format("{{\"bindings\":{{{}}},\"facts\":[{}]}}", bindings, facts);
}

std::string json_answers(std::span<const Answer> answers) { return fmt::format("[{}]", joined(answers, json_answer)); }

std::string json_values(std::span<const Datum> values) {
  const auto text = [](const Datum& value) {
    return json_string(value.is_string() ? std::string(value.text()) : write(value));
  };
  return fmt::format("[{}]", joined(values, text));
}

}  // namespace pizarra::repl
