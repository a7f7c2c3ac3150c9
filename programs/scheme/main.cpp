// Runs one agent that is a Scheme file, in a process of its own, or tries it on a story without a cell.

#include <filesystem>
#include <fmt/format.h>

#include "agents/launcher/run_directory.hpp"
#include "agents/scheme/scheme_agent.hpp"
#include "blackboard/client/keyed_board.hpp"
#include "blackboard/time/real_executor.hpp"
#include "blackboard/time/stop_signals.hpp"
#include "lisp/outside_text.hpp"
#include "programs/command_line/command_line.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/command_line/key_option.hpp"
#include "programs/scheme/process_limits.hpp"
#include "programs/scheme/trial.hpp"

namespace pizarra::programs {

namespace {

struct SchemeChoices {
  std::string file;
  std::string name;
  std::string board;
  std::string cell;
  std::string key;
  std::string host = "localhost";
  std::string story;
  int time_ms = 1000;
  int memory_mb = 64;
  double messages_per_s = 1000;
};

void log_line(const std::string& line) { fmt::print(stderr, "pizarra: {}\n", text_of_bytes(line)); }

std::string name_of(const SchemeChoices& choices) {
  return choices.name.empty() ? std::filesystem::path(choices.file).stem().string() : choices.name;
}

scheme::SchemeOptions options_of(const SchemeChoices& choices) {
  return {.file = choices.file,
          .limits = {.time = std::chrono::milliseconds(choices.time_ms),
                     .memory_mb = choices.memory_mb,
                     .own_process = true},
          .messages_per_s = choices.messages_per_s,
          .log = log_line};
}

int run_trial(const SchemeChoices& choices) {
  const Result<Source> story = read_source_file(choices.story);
  if (!story) return complain(story.error(), exit_usage);
  const Result<std::vector<std::string>> wrong = try_agent(name_of(choices), options_of(choices), *story);
  if (!wrong) return complain(wrong.error(), exit_usage);
  for (const std::string& what : *wrong) fmt::print(stderr, "pizarra: {}\n", what);
  const std::string steps = counted(story->data().size(), "step");
  if (wrong->empty()) fmt::print("{}: {}, all as expected\n", choices.story, steps);
  return wrong->empty() ? exit_reached : exit_failed;
}

// That of the cell that runs here, where no other is named.
Result<void> find_board(SchemeChoices& choices) {
  if (!choices.board.empty()) return {};
  const Result<launcher::RunState> run = launcher::find_run(choices.cell);
  if (!run) return fail(run);
  choices.board = run->board_address;
  if (choices.key.empty()) choices.key = run->key;
  return {};
}

// The interpreter starts its threads with the first program.
Result<void> limit(const SchemeChoices& choices) {
  const auto first = forms::AgentProgram::load("first", "", "first", {});
  if (!first) return fail(first);
  return limit_process(choices.memory_mb);
}

int run_agent(SchemeChoices choices) {
  const Result<void> found = find_board(choices);
  if (!found) return complain(found.error(), exit_unavailable);
  const std::string name = name_of(choices);
  if (!is_symbol_name(name)) {
    const Failure bad{
        "bad-name", fmt::format("an agent cannot be called {}: --name says how", text_of_bytes(name)), {}, {}};
    return complain(bad, exit_usage);
  }
  RealExecutor executor;
  const StopSignals signals(executor);
  const auto board = client::keyed_board(executor, choices.board, choices.key, name);
  if (!board) return complain(board.error(), exit_usage);
  const Result<void> limited = limit(choices);
  if (!limited) return complain(limited.error(), exit_unavailable);
  scheme::SchemeAgent agent({name, choices.host, executor, **board, Random(1)}, options_of(choices));
  std::optional<Result<void>> ended;
  const Job job = executor.spawn([](scheme::SchemeAgent& running, std::optional<Result<void>>& end) -> Task<void> {
    end = co_await running.run();
  }(agent, ended));
  executor.run_until([&ended] { return ended.has_value(); });
  if (signals.received()) return exit_reached;
  if (!ended || *ended) return exit_failed;
  const bool hopeless = ended->error().symbol == "wrong-shape";
  return complain(ended->error(), hopeless ? exit_usage : exit_failed);
}

void add_scheme_command(CLI::App& app, int& status) {
  auto choices = std::make_shared<SchemeChoices>();
  CLI::App* word = app.add_subcommand("scheme", "Run a Scheme file as an agent, or try it on a story.");
  word->add_option("FILE", choices->file, "The agent's file; it is loaded again whenever it is saved")
      ->required()
      ->check(CLI::ExistingFile);
  word->add_option("--try", choices->story, "Try it on this story instead of a board, and report every difference")
      ->check(CLI::ExistingFile);
  word->add_option("--name", choices->name, "Its name on the board; default: the file's");
  word->add_option("--board", choices->board, "The board's address; default: the cell that runs here");
  word->add_option("--cell", choices->cell, "The running cell of this name, where several run here");
  add_key_option(word, choices->key);
  word->add_option("--host", choices->host, "The host that it names in its presence")->capture_default_str();
  word->add_option("--time", choices->time_ms, "The most time that loading and each run may take, in milliseconds")
      ->check(number_check(10, 60000))
      ->capture_default_str();
  word->add_option("--memory", choices->memory_mb, "The most memory that a run may take and the agent may keep, in MB")
      ->check(number_check(8, 4096))
      ->capture_default_str();
  word->add_option("--rate", choices->messages_per_s, "The most facts and questions a second")
      ->check(number_check(1, 100000))
      ->capture_default_str();
  word->footer(help_footer("scheme examples/10-conveyor/conveyor.scm"));
  word->callback([choices, &status] { status = choices->story.empty() ? run_agent(*choices) : run_trial(*choices); });
}

}  // namespace
}  // namespace pizarra::programs

int main(int argc, char** argv) {
  CLI::App app("An agent that is a Scheme file.", "pizarra");
  app.require_subcommand(1);
  app.set_version_flag("--version", pizarra::programs::version());
  app.footer(pizarra::programs::exit_code_help);
  int status = pizarra::programs::exit_reached;
  pizarra::programs::add_scheme_command(app, status);
  return pizarra::programs::run_program(app, argc, argv, status);
}
