// `down`: the end of a cell that runs here, on all its hosts of this machine or on one.

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fmt/format.h>
#include <unistd.h>

#include "agents/launcher/run_directory.hpp"
#include "lisp/forms/cell_file.hpp"
#include "lisp/nearest.hpp"
#include "lisp/outside_text.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/commands/commands.hpp"

namespace pizarra::programs {

namespace {

using launcher::RunState;

struct DownChoices {
  std::string cell;
  std::string host;
};

// A cell's file, as `up` takes it, or its name.
Result<std::string> name_of(const std::string& cell) {
  if (!std::filesystem::is_regular_file(cell)) return cell;
  const Result<forms::CellDescription> described = forms::read_cell_file(cell);
  if (!described) return fail(described);
  return described->name;
}

// Of the cells that run here, the one that was probably meant.
std::string likely_cell(const std::string& cell, const std::vector<RunState>& runs) {
  if (cell.empty()) return {};
  std::vector<std::string> names;
  for (const RunState& run : runs) names.push_back(run.cell);
  const std::string near = nearest_name(cell, names);
  return near.empty() || near == cell ? std::string() : fmt::format("; did you mean {}?", near);
}

// What was named: the runs of one cell.
Result<std::vector<RunState>> runs_of(const std::string& cell, const std::string& host) {
  std::vector<RunState> runs = launcher::running_cells();
  const std::string meant = likely_cell(cell, runs);
  if (!cell.empty()) std::erase_if(runs, [&](const RunState& run) { return run.cell != cell; });
  if (!host.empty()) std::erase_if(runs, [&](const RunState& run) { return run.host != host; });
  if (runs.empty()) {
    const std::string which = cell.empty() ? "no cell" : "no cell named " + text_of_bytes(cell);
    const std::string where = host.empty() ? "" : " on the host " + text_of_bytes(host);
    return fail("nothing-runs", fmt::format("{} runs here{}{}", which, where, meant));
  }
  // They are sorted by cell.
  if (runs.front().cell != runs.back().cell) {
    return fail("which-cell", fmt::format("several cells run here, {} and {} among them: name one", runs.front().cell,
                                          runs.back().cell));
  }
  return runs;
}

int run_down(const DownChoices& choices) {
  const Result<std::string> name = name_of(choices.cell);
  if (!name) return complain(name.error(), exit_usage);
  Result<std::vector<RunState>> runs = runs_of(*name, choices.host);
  if (!runs) return complain(runs.error(), exit_unavailable);
  for (const RunState& run : *runs) kill(run.supervisor_pid, SIGTERM);
  constexpr int tries = 60;
  for (int n = 0; n < tries && std::ranges::any_of(*runs, launcher::still_runs); ++n) usleep(100'000);
  bool all = true;
  for (const RunState& run : *runs) {
    const bool runs_on = launcher::still_runs(run);
    all = all && !runs_on;
    fmt::print(runs_on ? stderr : stdout, "{} on {}, process {}, {}\n", run.cell, run.host, run.supervisor_pid,
               runs_on ? "does not end" : "has ended");
  }
  return all ? exit_reached : exit_failed;
}

}  // namespace

void add_down_command(CLI::App& app, int& status) {
  auto choices = std::make_shared<DownChoices>();
  CLI::App* down =
      app.add_subcommand("down", "Stop a cell that runs here, on all its hosts of this machine or on one.");
  down->add_option("CELL,--cell", choices->cell, "Its name or its cell file; default: the only one");
  down->add_option("--host", choices->host, "Stop this host of it alone");
  down->footer(help_footer("down blocks"));
  down->callback([choices, &status] { status = run_down(*choices); });
}

}  // namespace pizarra::programs
