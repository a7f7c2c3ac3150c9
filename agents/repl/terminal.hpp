#pragma once

// The prompt: reads lines with editing, history and completion from a terminal, or plainly from a pipe, without
// blocking the executor, and shows what comes meanwhile above what is being typed.
//
//   Terminal terminal(executor, "pizarra> ");
//   terminal.words = [&] { return interpreter.words(); };
//   std::optional<std::string> typed = co_await terminal.read();   // a whole form; empty at the end of the input
//
// On a terminal Ctrl-C drops what has been typed; with nothing typed it is the end of the input, as Ctrl-D is. One at a
// time in a process. The history is kept in $XDG_STATE_HOME/pizarra/history (~/.local/state by default).

#include <functional>
#include <optional>
#include <set>
#include <string>

#include "agents/repl/signal_pipe.hpp"
#include "blackboard/time/latch.hpp"

namespace pizarra::repl {

// Whether every list and string that was opened is closed, up to where the text cannot be read.
bool is_complete(std::string_view text);

class Terminal {
 public:
  Terminal(Executor& executor, std::string prompt);
  ~Terminal();
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  // Lines are joined until the form is complete. Input beyond 64 KiB without an end is given back as it is.
  Task<std::optional<std::string>> read();
  void print(const std::string& line);

  // Whether a person types at it.
  bool interactive() const { return interactive_; }
  // Whether a signal ended the input.
  bool interrupted() const { return interrupted_; }

  std::function<const std::set<std::string>&()> words;
  // Ctrl-C while no line is being read.
  std::function<void()> on_interrupt;

 private:
  static constexpr std::size_t max_form_bytes = 64 << 10;

  void listen();
  void stop_listening();
  void read_plainly();
  void show_prompt();
  void hide_prompt();
  void erase_line();
  void drop_line();
  void on_signal(int signal);
  std::string_view prompt() const;
  void take_line(std::optional<std::string> line);
  static void line_typed(char* line);
  static char** complete(const char* text, int begin, int end);

  Executor& executor_;
  std::string prompt_;
  bool interactive_;
  bool prompting_ = false;
  bool ended_ = false;
  bool interrupted_ = false;
  std::optional<SignalPipe> signals_;        // on a terminal
  std::string partial_;                      // lines of a form that is not complete yet
  std::string unread_;                       // what came behind them
  Queue<std::optional<std::string>> lines_;  // at most the piece that was asked for
};

}  // namespace pizarra::repl
