#pragma once

// The commands of the prompt as a table: the word, how it is written, what it does in one line, and who does it.
//
//   Commands commands(prompt, service, Patience::ended);
//   if (const Command* command = commands.find("ask")) outcome = co_await command->run(typed);

#include <span>
#include <string_view>

#include "agents/repl/goal_commands.hpp"
#include "agents/repl/name_commands.hpp"
#include "agents/repl/watch_commands.hpp"

namespace pizarra::repl {

struct Command {
  std::string_view name;
  std::string_view usage;
  std::string_view help;
  std::function<Task<Evaluation>(Typed typed)> run;
};

class Commands {
 public:
  // Both outlive it.
  Commands(Prompt& prompt, const runtime::Service& service, Patience patience);
  Commands(const Commands&) = delete;
  Commands& operator=(const Commands&) = delete;

  std::span<const Command> all() const { return all_; }
  // Null: there is none of this name.
  const Command* find(std::string_view name) const;
  // That this begins neither with a command nor with an agent that is present, and which of them is near.
  Task<Failure> unknown(Datum form);

 private:
  std::vector<Command> table();
  Task<Evaluation> help(Typed typed);
  Task<Evaluation> help_with(Datum word);

  Prompt& prompt_;
  GoalCommands goals_;
  NameCommands names_;
  WatchCommands watches_;
  std::vector<Command> all_;
};

}  // namespace pizarra::repl
