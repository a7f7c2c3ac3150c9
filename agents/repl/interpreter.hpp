#pragma once

// Carries out the forms that a person types: they talk to the board and to the agents on it.
//
//   Interpreter interpreter(context, service, [](const std::string& line) { ... });
//   Evaluation outcome = co_await interpreter.evaluate("(ask (on ?x ?y))");
//
// Commands are listed in repl_commands(). A form that begins with an agent's name asks that agent: `(robot (monitor))`.
// Every answer is given to the output, a line at a time; a failure is one line, with the place below where text was
// read. In the style for programs each line is a JSON object (docs/commands.md); the commands that only a person needs
// have none. At most 32 watches run at once.

#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include "agents/runtime/naming.hpp"
#include "agents/runtime/roles.hpp"

namespace pizarra::repl {

enum class Evaluation : std::uint8_t {
  done,
  failed,       // an agent or the board did not do it
  unavailable,  // the board did not answer
  refused,      // the goal was understood and cannot be reached
  malformed,    // what was typed could not be read or is not a command
  quit,
};

enum class Style : std::uint8_t { text, json };

using Output = std::function<void(const std::string& line)>;

class Interpreter {
 public:
  static constexpr std::size_t max_watches = 32;
  // Whether `(goal ...)` answers when the goal was accepted or when it has ended.
  enum class Patience : std::uint8_t { accepted, ended };

  Interpreter(runtime::AgentContext& context, const runtime::Service& service, Output output, Patience patience,
              Style style = Style::text);

  // All the forms of `text`, one after another, up to the first that fails.
  Task<Evaluation> evaluate(std::string text);

  // The words that may be typed: commands, agents and what they offer, relations, objects. As of the last evaluation.
  const std::set<std::string>& words() const { return words_; }
  Task<void> learn_words();

 private:
  friend struct Command;

  Task<Evaluation> evaluate_form(Datum form);
  Task<Evaluation> help(Datum form);
  Task<Evaluation> help_with(Datum word);
  Task<Evaluation> goal(Datum form);
  Task<Evaluation> ask(Datum form);
  Task<Evaluation> declare(Datum form);
  Task<Evaluation> tell(Datum form);
  Task<Evaluation> retract(Datum form);
  Task<Evaluation> watch(Datum form);
  Task<Evaluation> unwatch(Datum form);
  Task<Evaluation> objects(Datum form);
  Task<Evaluation> plan(Datum form);
  Task<Evaluation> why(Datum form);
  Task<Evaluation> why_fact(Datum pattern);
  Task<Evaluation> agents(Datum form);
  Task<Evaluation> cancel(Datum form);
  Task<Evaluation> quit(Datum form);
  Task<Evaluation> find(Datum form);
  Task<Evaluation> name_agent(Datum form);
  Task<Evaluation> unbind(Datum form);
  Task<Evaluation> resolve(Datum form);
  Task<Evaluation> list_names(Datum form);
  Task<Result<runtime::Reference>> agent_called(std::string name);
  Task<Evaluation> wire(Datum form);
  Task<Evaluation> list_wiring();
  // (holder CLIENT ROLE SERVER STATE) of each client, all prompts being one.
  Task<Result<std::vector<Datum>>> holders();
  Task<Result<Datum>> role_of(Datum client, Datum role);
  Task<Result<std::string>> remark_on_server(Datum server, Datum present);
  // The agent that plays this role for the prompt.
  Task<std::string> serving(runtime::Role role);
  // The same where it must be present: failure absent, which says what it is needed for.
  Task<Result<std::string>> present_coordinator(std::string needed_for);
  Task<Evaluation> request(std::string agent, Datum operation);
  // Sentences that an answer of the eyes has no room for: why it is FAIL, and what the learned object looks like.
  Task<std::vector<Datum>> remarks_on(std::string agent, Datum operation, Datum answer);
  Task<std::vector<Datum>> remarks_on_mode(Datum eyes);
  // Why these eyes have no images though somebody wants them, once that is known; empty: they have, or have no camera.
  Task<std::string> why_blind(Datum eyes);
  Task<Evaluation> wait_for_end(Datum number, std::string typed);
  Task<bool> being_taught();
  Task<bool> is_agent(std::string name);
  // `(OPERATION (PARAMETER KIND) ...)` of each.
  Task<std::vector<Datum>> offers_of(Datum agent);
  Task<void> follow(int number, std::unique_ptr<Watch> watch);

  // Neither a command nor who is present.
  Task<Failure> unknown_command(Datum form);
  void say_end(const Datum& state, const std::string& typed);
  void say_change(int number, const Change& change, bool first);
  void say(const std::string& text, const std::string& json);
  Evaluation show(const Failure& failure, Evaluation outcome);
  // Shows the board's answer, or that none came.
  Evaluation show(const Failure& failure);
  Evaluation usage(std::string_view command);

  runtime::AgentContext& context_;
  runtime::Caller caller_;
  runtime::Naming naming_;
  Output output_;
  Patience patience_;
  Style style_;
  std::set<std::string> words_;
  int next_watch_ = 1;
  std::map<int, Job> watches_;
};

}  // namespace pizarra::repl
