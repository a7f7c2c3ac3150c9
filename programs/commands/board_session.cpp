#include "programs/commands/board_session.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <unistd.h>

#include "agents/repl/answer_text.hpp"
#include "agents/repl/repl.hpp"
#include "blackboard/away.hpp"
#include "blackboard/client/keyed_board.hpp"
#include "blackboard/client/remote_board.hpp"
#include "blackboard/time/real_executor.hpp"
#include "blackboard/time/stop_signals.hpp"
#include "lisp/outside_text.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/command_line/key_option.hpp"

namespace pizarra::programs {

namespace {

constexpr Duration answer_timeout = 5s;
// Longer than a supervisor takes to start a board again.
constexpr Duration longest_silence = 10s;
// One that ends in order may be started again in its place.
constexpr Duration longest_goodbye = 1s;
constexpr Duration look_pause = 200ms;
constexpr Duration quick_answer = 2s;
constexpr Duration goodbye_timeout = 500ms;

Task<void> pause(Executor& executor, Duration duration) { co_await sleep(executor, duration); }

// Where nothing comes for long, who waits is told what for.
Task<void> say_what_is_waited_for(Executor& executor, const client::RemoteBoard& board, std::string address) {
  co_await sleep(executor, quick_answer);
  if (board.silence() >= quick_answer)
    fmt::print(stderr, "pizarra: waiting for a board at {}\n", text_of_bytes(address));
}

int status_of(repl::Evaluation evaluation) {
  switch (evaluation) {
    case repl::Evaluation::done:
    case repl::Evaluation::quit:
      return exit_reached;
    case repl::Evaluation::malformed:
      return exit_usage;
    case repl::Evaluation::refused:
      return exit_refused;
    case repl::Evaluation::unavailable:
      return exit_unavailable;
    case repl::Evaluation::failed:
      break;
  }
  return exit_failed;
}

std::optional<launcher::RunState> run_with_board(const std::string& address) {
  const std::vector<launcher::RunState> runs = launcher::running_cells();
  const auto found = std::ranges::find(runs, address, &launcher::RunState::board_address);
  return found == runs.end() ? std::nullopt : std::optional(*found);
}

// A cell that was started anew in its place is as good.
Loss loss_of(const client::RemoteBoard& board, const Destination& to) {
  return [&board, &to, run = to.run]() mutable -> std::optional<Failure> {
    if (run && !launcher::still_runs(*run)) {
      const std::optional<launcher::RunState> anew = run_with_board(to.address);
      if (!anew) return Failure{"unreachable", fmt::format("the cell {} has ended", run->cell), {}, {}};
      run = anew;
    }
    const bool ended = board.said_goodbye() && board.silence() >= longest_goodbye;
    if (ended) return Failure{"unreachable", "the board has ended", to_datum(to.address), {}};
    if (board.silence() < longest_silence) return std::nullopt;
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(longest_silence).count();
    const std::string sentence = fmt::format("the board has answered nothing for {} s", seconds);
    return Failure{"unreachable", sentence, to_datum(to.address), {}};
  };
}

}  // namespace

int complain_as(repl::Style style, const Failure& failure, ExitCode code) {
  if (style == repl::Style::text) return complain(failure, code);
  fmt::print("{}\n", json_error(failure));
  return code;
}

int complain_of_board(repl::Style style, const Failure& failure) {
  return complain_as(style, failure, is_away(failure) ? exit_unavailable : exit_failed);
}

void add_board_options(CLI::App* word, BoardChoices& choices) {
  word->add_option("--board", choices.board, "The board's address; default: the cell that runs here");
  word->add_option("--cell", choices.cell, "The cell of this name that runs here");
  add_key_option(word, choices.key);
}

Result<Destination> destination(const BoardChoices& choices) {
  if (!choices.board.empty()) return Destination{choices.board, choices.key, run_with_board(choices.board)};
  Result<launcher::RunState> run = launcher::find_run(choices.cell);
  if (!run) return fail(run);
  const std::string key = choices.key.empty() ? run->key : choices.key;
  return Destination{run->board_address, key, std::move(*run)};
}

std::string prompt_name() { return fmt::format("prompt-{}", getpid()); }

BoardSession::BoardSession(Executor& executor, Board& board, Manner manner, Loss loss)
    : manner_(manner),
      loss_(std::move(loss)),
      context_{prompt_name(), "localhost", executor, board, Random(1)},
      service_(context_, runtime::contract_from_text("(contract prompt)").value()),
      interpreter_(
          context_, service_, [this](const std::string& line) { print(line); }, manner.patience, manner.style) {}

int BoardSession::run(const std::vector<std::string>& forms) {
  {
    const Job talking = context_.executor.spawn(talk(forms));
    context_.executor.run_until([&] { return talking.done() || gone_; });
    const bool interrupted = !talking.done() && !gone_;
    if (interrupted) status_ = exit_interrupted;
  }
  if (!gone_ && service_.presence() != 0) say_goodbye();
  return status_;
}

// Its presence goes at once, and does not stand until its lease has lapsed.
void BoardSession::say_goodbye() {
  const Job leaving = context_.executor.spawn(leave());
  const Job patience = context_.executor.spawn(pause(context_.executor, goodbye_timeout));
  context_.executor.run_until([&] { return leaving.done() || patience.done(); });
}

// Where it is not heard the lease lapses.
Task<void> BoardSession::leave() { [[maybe_unused]] const Result<void> left = co_await service_.leave(0s); }

void BoardSession::print(const std::string& said) {
  const std::string line = lines_of_bytes(said);
  if (terminal_ != nullptr) return terminal_->print(line);
  fmt::print("{}\n", line);
  std::fflush(stdout);
}

Task<Result<void>> BoardSession::reach_board() {
  // Nothing, which any board answers, if it is there.
  const std::vector<Relation> nothing;
  const Result<void> answered = co_await context_.board.declare(nothing);
  if (!answered) co_return answered;
  if (!manner_.present) co_return {};
  co_return co_await service_.start();
}

Task<void> BoardSession::talk(std::vector<std::string> forms) {
  const Result<void> reached = co_await reach_board();
  if (!reached) {
    status_ = complain_of_board(manner_.style, reached.error());
    co_return;
  }
  if (loss_) looking_ = context_.executor.spawn(look_after_board());
  if (manner_.prepared) {
    const Result<void> prepared = co_await manner_.prepared(context_.board);
    if (!prepared) {
      status_ = complain_as(manner_.style, prepared.error(), exit_unavailable);
      co_return;
    }
  }
  if (forms.empty()) {
    co_await prompt();
  } else {
    co_await evaluate(std::move(forms));
  }
}

Task<void> BoardSession::evaluate(std::vector<std::string> forms) {
  const repl::Evaluation end = co_await repl::run_forms(interpreter_, std::move(forms));
  status_ = status_of(end);
  const bool only_asked = !manner_.stay || status_ != exit_reached;
  if (only_asked) co_return;
  // Until a signal ends it.
  while (true) co_await sleep(context_.executor, 1s);
}

Task<void> BoardSession::prompt() {
  repl::Terminal terminal(context_.executor, "pizarra> ");
  terminal_ = &terminal;
  const repl::Evaluation first_failure = co_await repl::run_prompt(context_, interpreter_, terminal);
  terminal_ = nullptr;
  // A person has seen what failed.
  if (!terminal.interactive()) status_ = status_of(first_failure);
  if (terminal.interrupted()) status_ = exit_interrupted;
}

// Ends when the board is gone, unless a person sits at the prompt.
Task<void> BoardSession::look_after_board() {
  bool lost = false;
  while (true) {
    const std::optional<Failure> loss = loss_();
    const bool stays = terminal_ != nullptr && terminal_->interactive();
    if (loss && !stays) {
      status_ = complain_as(manner_.style, *loss, exit_unavailable);
      gone_ = true;
      co_return;
    }
    if (loss && !lost) {
      print(describe(*loss) + "; what asks for it fails until it is there again");
      if (terminal_->on_interrupt) terminal_->on_interrupt();
    }
    if (!loss && lost) print("the board is there again");
    lost = loss.has_value();
    co_await sleep(context_.executor, look_pause);
  }
}

int talk_to(const Destination& to, const std::vector<std::string>& forms, Manner manner) {
  RealExecutor executor;
  // A prompt has its own way with them.
  std::optional<StopSignals> signals;
  if (!forms.empty()) signals.emplace(executor);
  const auto board = client::keyed_board(executor, to.address, to.key, prompt_name(), answer_timeout);
  if (!board) return complain_as(manner.style, board.error(), exit_usage);
  const Job waiting = executor.spawn(say_what_is_waited_for(executor, **board, to.address));
  return BoardSession(executor, **board, manner, loss_of(**board, to)).run(forms);
}

}  // namespace pizarra::programs
