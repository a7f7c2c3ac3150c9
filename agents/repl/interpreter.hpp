#pragma once

// What a person types, done: forms that talk to the board and to the agents on it.
//
//   Interpreter interpreter(context, service, [](const std::string& line) { ... });
//   Outcome outcome = co_await interpreter.evaluate("(ask (on ?x ?y))");
//
// Commands are listed in repl_commands(). A form that begins with an agent's name asks that agent: `(robot (monitor))`.
// Every answer is given to the output, a line at a time; a failure is one line, with the place below where text was
// read. At most 32 watches run at once.

#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include "agents/runtime/service.hpp"

namespace pizarra {

enum class Outcome : std::uint8_t {
  done,
  failed,     // an agent or the board refused
  malformed,  // what was typed could not be read or is not a command
  quit,
};

using Output = std::function<void(const std::string& line)>;

class Interpreter {
 public:
  static constexpr std::size_t max_watches = 32;
  // Whether `(goal ...)` answers when the goal was accepted or when it has ended.
  enum class Patience : std::uint8_t { accepted, ended };

  Interpreter(AgentContext& context, const Service& service, Output output, Patience patience);

  // All the forms of `text`, one after another, up to the first that fails.
  Task<Outcome> evaluate(std::string text);

  // What may be typed: commands, agents and what they offer, relations, objects. As of the last evaluation.
  const std::set<std::string>& words() const { return words_; }
  Task<void> learn_words();

 private:
  friend struct Command;
  struct Watching;

  Task<Outcome> evaluate_form(Datum form);
  Task<Outcome> help(Datum form);
  Task<Outcome> goal(Datum form);
  Task<Outcome> ask(Datum form);
  Task<Outcome> tell(Datum form);
  Task<Outcome> retract(Datum form);
  Task<Outcome> watch(Datum form);
  Task<Outcome> unwatch(Datum form);
  Task<Outcome> objects(Datum form);
  Task<Outcome> plan(Datum form);
  Task<Outcome> why(Datum form);
  Task<Outcome> agents(Datum form);
  Task<Outcome> cancel(Datum form);
  Task<Outcome> quit(Datum form);
  Task<Outcome> request(std::string agent, Datum operation);
  Task<Outcome> wait_for_end(Datum number);
  Task<bool> is_agent(std::string name);
  Task<void> follow(int number, std::unique_ptr<Watch> watch);

  Outcome show(const Failure& failure, Outcome outcome = Outcome::failed);
  Outcome usage(std::string_view command);

  AgentContext& context_;
  Caller caller_;
  Output output_;
  Patience patience_;
  std::set<std::string> words_;
  int next_watch_ = 1;
  std::map<int, Job> watches_;
};

}  // namespace pizarra
