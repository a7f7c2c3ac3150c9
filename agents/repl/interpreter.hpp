#pragma once

// Carries out the forms that a person types: they talk to the board and to the agents on it.
//
//   Interpreter interpreter(context, service, [](const std::string& line) { ... }, Patience::ended);
//   Evaluation outcome = co_await interpreter.evaluate("(ask (on ?x ?y))");
//
// A form begins with a command (commands.hpp) or with an agent's name, which asks that agent: `(robot (monitor))`.
// Every answer is given to the output, a line at a time; a failure is one line, with the place below where text was
// read. In the style for programs each line is a JSON object (docs/commands.md); the commands that only a person needs
// have none.

#include <set>

#include "agents/repl/commands.hpp"

namespace pizarra::repl {

class Interpreter {
 public:
  Interpreter(runtime::AgentContext& context, const runtime::Service& service, Output output, Patience patience,
              Style style = Style::text);

  // All the forms of `text`, one after another, up to the first that fails.
  Task<Evaluation> evaluate(std::string text);

  std::span<const Command> commands() const { return commands_.all(); }
  // The words that may be typed: commands, and the names that learn_words() has found on the board.
  const std::set<std::string>& words() const { return words_; }
  Task<void> learn_words();

 private:
  Task<Evaluation> evaluate_form(Datum form);

  Prompt prompt_;
  Commands commands_;
  std::set<std::string> words_;
};

}  // namespace pizarra::repl
