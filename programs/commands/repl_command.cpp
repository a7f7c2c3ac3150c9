// `repl`: a prompt on the cell that runs here, or on one in this process.

#include <algorithm>
#include <fmt/format.h>
#include <unistd.h>

#include "agents/launcher/local_cell.hpp"
#include "agents/launcher/readiness.hpp"
#include "blackboard/time/real_executor.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/commands/board_session.hpp"
#include "programs/commands/commands.hpp"

namespace pizarra::programs {

namespace {

struct ReplChoices {
  BoardChoices board;
  std::string cell_file;
  std::vector<std::string> forms;
  std::vector<std::string> agents;
  std::uint64_t seed = 1;
  std::string of_own_cell;  // what was given that says something of a cell in this process alone
};

bool is_script(const ReplChoices& choices) { return !choices.forms.empty() || isatty(STDIN_FILENO) == 0; }

// A person goes on typing while a goal is pursued; a script waits.
Manner manner_of(const ReplChoices& choices) {
  return {.patience = is_script(choices) ? repl::Patience::ended : repl::Patience::accepted};
}

// A script finds everybody at work; who runs but a few agents teaches for himself.
Task<Result<void>> await_cell(launcher::LocalCell& cell, Board& board, std::vector<std::string> kinds, bool whole) {
  const Result<void> there = co_await launcher::await_agents(cell, board, kinds);
  if (!there) co_return there;
  const Result<void> met = co_await launcher::await_devices(cell, board, kinds);
  if (!met) co_return met;
  const bool taught = whole && std::ranges::find(kinds, "person") != kinds.end();
  if (!taught) co_return {};
  co_return co_await launcher::await_teaching(board, cell.executor());
}

int talk_to_own_cell(const ReplChoices& choices) {
  const Result<forms::CellDescription> cell = forms::read_cell_file(choices.cell_file);
  if (!cell) return complain(cell.error(), exit_usage);
  const Result<simulation::WorldConfig> sound = launcher::world_config(*cell, choices.seed);
  if (!sound) return complain(sound.error(), exit_usage);
  RealExecutor executor;
  launcher::LocalCell local(executor, *cell, choices.seed);
  const bool whole = choices.agents.empty();
  const std::vector<std::string> kinds = whole ? launcher::named_agents(*cell) : choices.agents;
  for (const std::string& kind : kinds) {
    const Result<void> started = local.start(kind);
    if (!started) return complain(started.error(), exit_usage);
  }
  Manner manner = manner_of(choices);
  if (is_script(choices)) {
    manner.prepared = [&local, &kinds, whole](Board& board) { return await_cell(local, board, kinds, whole); };
  }
  const std::unique_ptr<Board> view = local.board().view(prompt_name());
  return BoardSession(executor, *view, manner).run(choices.forms);
}

int run_repl(const ReplChoices& choices) {
  const bool own =
      !choices.agents.empty() || (!choices.board.ask_for_running_cell() && launcher::running_cells().empty());
  if (own) return talk_to_own_cell(choices);
  if (!choices.of_own_cell.empty()) {
    const std::string sentence = fmt::format(
        "{} is for a cell in this process, and this prompt talks to one that runs already: leave it out, "
        "or end that one first (`down`)",
        choices.of_own_cell);
    return complain(Failure{"bad-option", sentence, {}, {}}, exit_usage);
  }
  const Result<Destination> to = destination(choices.board);
  if (!to) return complain(to.error(), exit_unavailable);
  return talk_to(*to, choices.forms, manner_of(choices));
}

}  // namespace

void add_repl_command(CLI::App& app, int& status) {
  auto choices = std::make_shared<ReplChoices>();
  choices->cell_file = shipped_file("examples/01-blocks/cell.scm");
  CLI::App* repl = app.add_subcommand(
      "repl", "Open a prompt on the cell that runs here. Where none runs, the demo cell starts in this process.");
  repl->add_option("CELL", choices->cell_file, "The cell file to run in this process")
      ->check(CLI::ExistingFile)
      ->capture_default_str();
  repl->add_option("--eval", choices->forms, "Evaluate this form and end; may be repeated");
  repl->add_option("--agents", choices->agents, "Run only these agents, on a board in this process: vision,robot")
      ->delimiter(',')
      ->check(launcher::kind_fault);
  repl->add_option("--seed", choices->seed, "The seed of all chance")->check(seed_check())->capture_default_str();
  add_board_options(repl, choices->board);
  repl->footer(help_footer("repl --eval '(goal (on circle triangle))'"));
  repl->callback([choices, repl, &status] {
    if (repl->get_option("--seed")->count() > 0) choices->of_own_cell = "--seed";
    if (repl->get_option("CELL")->count() > 0) choices->of_own_cell = choices->cell_file;
    status = run_repl(*choices);
  });
}

}  // namespace pizarra::programs
