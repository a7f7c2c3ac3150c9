#include "agents/repl/answer_text.hpp"

#include <fmt/format.h>

#include "lisp/writer.hpp"

namespace pizarra::repl {

std::string bindings_text(const Answer& answer) {
  if (answer.bindings.all().empty()) return "yes";
  std::string text;
  for (const auto& [variable, value] : answer.bindings.all()) {
    text += fmt::format("{}{} = {}", text.empty() ? "" : "  ", variable.text(), write(value));
  }
  return text;
}

}  // namespace pizarra::repl
