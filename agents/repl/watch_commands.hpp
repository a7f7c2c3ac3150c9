#pragma once

// The watches of the prompt: each shows what holds, then every change, until it is ended by its number or the prompt
// ends. At most `max_watches` run at once.
//
//   WatchCommands watches(prompt);
//   co_await watches.watch(typed);         // (watch (on ?x ?y))
//   co_await watches.unwatch(typed);       // (unwatch 1)

#include <map>

#include "agents/repl/prompt.hpp"

namespace pizarra::repl {

class WatchCommands {
 public:
  static constexpr std::size_t max_watches = 32;

  // The prompt outlives it.
  explicit WatchCommands(Prompt& prompt) : prompt_(prompt) {}

  Task<Evaluation> watch(Typed typed);
  Task<Evaluation> unwatch(Typed typed);

 private:
  Task<void> follow(int number, std::unique_ptr<Watch> watch);
  void say_change(int number, const Change& change, bool first);

  Prompt& prompt_;
  int next_watch_ = 1;
  std::map<int, Job> watches_;
};

}  // namespace pizarra::repl
