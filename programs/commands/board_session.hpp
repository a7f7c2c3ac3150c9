#pragma once

// The session of a word with a board: forms, one after another, or the prompt where there are none.
//
//   add_board_options(word, choices);                                  // --board, --cell, --key
//   const Result<Destination> to = destination(choices);               // nothing-runs, which-cell
//   return talk_to(*to, {"(ask (on ?x ?y))"}, {.style = Style::json});  // the exit status
//
// A board elsewhere may go while something of it is waited for. It is gone at once when it is that of a cell which runs
// here and ends, a second after it has said goodbye, else when it has answered nothing for `longest_silence`; one that
// comes back before is none the wiser. Then the talk ends with exit_unavailable; a prompt that a person types at says
// so and stays. A session that ends, also by a signal that ended its executor, takes its presence along.

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "agents/launcher/run_directory.hpp"
#include "agents/repl/interpreter.hpp"
#include "agents/repl/terminal.hpp"
#include "programs/command_line/exit_codes.hpp"

namespace pizarra::programs {

struct BoardChoices {
  std::string board;  // an address
  std::string cell;   // the name of a running cell
  std::string key;    // the file of a secret key

  // So that no cell in this process takes its place.
  bool ask_for_running_cell() const { return !board.empty() || !cell.empty() || !key.empty(); }
};

void add_board_options(CLI::App* word, BoardChoices& choices);

// The board's address, the key to come with, and the cell that it belongs to where that runs here.
struct Destination {
  std::string address;
  std::string key;
  std::optional<launcher::RunState> run;
};

Result<Destination> destination(const BoardChoices& choices);

// The agents and relations that a form needs before it is evaluated, or the reason why they do not come.
using Preparation = std::function<Task<Result<void>>(Board&)>;

// How a word is to talk.
struct Manner {
  repl::Patience patience = repl::Patience::ended;
  repl::Style style = repl::Style::text;
  bool stay = false;    // until interrupted, also when the forms are done
  bool present = true;  // as an agent, which one must be to ask others
  Preparation prepared = nullptr;
};

// Why the board cannot be reached any more; nothing while it can.
using Loss = std::function<std::optional<Failure>()>;

// The name of this process on a board: its requests and what it holds there are one client's.
std::string prompt_name();

class BoardSession {
 public:
  BoardSession(Executor& executor, Board& board, Manner manner, Loss loss = nullptr);
  // The exit status.
  int run(const std::vector<std::string>& forms);

 private:
  void say_goodbye();
  Task<void> leave();
  void print(const std::string& line);
  Task<Result<void>> reach_board();
  Task<void> talk(std::vector<std::string> forms);
  Task<void> evaluate(std::vector<std::string> forms);
  Task<void> prompt();
  Task<void> look_after_board();

  Manner manner_;
  Loss loss_;
  runtime::AgentContext context_;
  runtime::Service service_;
  repl::Terminal* terminal_ = nullptr;
  repl::Interpreter interpreter_;
  int status_ = exit_reached;
  bool gone_ = false;
  Job looking_;
};

int talk_to(const Destination& to, const std::vector<std::string>& forms, Manner manner);

// Prints the failure, in the style for people to standard error.
int complain_as(repl::Style style, const Failure& failure, ExitCode code);
// With the status of what failed there: exit_unavailable when no board answered, exit_failed when it answered no.
int complain_of_board(repl::Style style, const Failure& failure);

}  // namespace pizarra::programs
