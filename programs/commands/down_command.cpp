// `down`: the end of a cell that runs here.

#include <csignal>
#include <filesystem>
#include <fmt/format.h>
#include <unistd.h>

#include "agents/launcher/run_directory.hpp"
#include "lisp/forms/cell_file.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/commands/commands.hpp"

namespace pizarra::programs {

namespace {

// A cell's file, as `up` takes it, or its name.
Result<std::string> name_of(const std::string& cell) {
  if (!std::filesystem::is_regular_file(cell)) return cell;
  const Result<forms::CellDescription> described = forms::read_cell_file(cell);
  if (!described) return fail(described);
  return described->name;
}

int run_down(const std::string& cell) {
  const Result<std::string> name = name_of(cell);
  if (!name) return complain(name.error(), exit_usage);
  const Result<launcher::RunState> run = launcher::find_run(*name);
  if (!run) return complain(run.error(), exit_unavailable);
  kill(run->supervisor_pid, SIGTERM);
  constexpr int tries = 60;
  for (int n = 0; n < tries && launcher::still_runs(*run); ++n) usleep(100'000);
  if (!launcher::still_runs(*run)) return exit_reached;
  fmt::print(stderr, "pizarra: process {} does not end\n", run->supervisor_pid);
  return exit_failed;
}

}  // namespace

void add_down_command(CLI::App& app, int& status) {
  auto cell = std::make_shared<std::string>();
  CLI::App* down = app.add_subcommand("down", "Stop a cell that runs here.");
  down->add_option("CELL,--cell", *cell, "Its name or its cell file; default: the only one");
  down->footer(help_footer("down blocks"));
  down->callback([cell, &status] { status = run_down(*cell); });
}

}  // namespace pizarra::programs
