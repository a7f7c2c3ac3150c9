// `cells`: how the cells of a hall do, a line each.

#include <algorithm>
#include <fmt/format.h>

#include "blackboard/client/keyed_board.hpp"
#include "blackboard/time/real_executor.hpp"
#include "lisp/outside_text.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/command_line/key_option.hpp"
#include "programs/commands/board_session.hpp"
#include "programs/commands/cell_sight.hpp"
#include "programs/commands/commands.hpp"

namespace pizarra::programs {

namespace {

constexpr Duration answers_within = 2s;

struct CellsChoices {
  bool json = false;
  BoardChoices board;
};

std::string or_dash(const std::string& text) { return text.empty() ? "-" : text_of_bytes(text); }

void print_cell(const CellSight& cell) {
  const std::string path = cell.path.empty() ? "." : cell.path;
  if (cell.fault) return fmt::print("{:<20} {}\n", path, text_of_bytes(describe(*cell.fault)));
  fmt::print("{:<20} {:>6}  {:<36} {:<24} {}\n", path, cell.agents, or_dash(cell.goal), or_dash(cell.arms),
             or_dash(cell.stops));
}

Task<void> look_into(std::vector<CellSight>* cells, Executor& executor, client::Contexts& contexts, std::string root) {
  *cells = co_await look_at_cells(executor, contexts, std::move(root));
}

int run_cells(const CellsChoices& choices) {
  const Result<Destination> to = destination(choices.board);
  if (!to) return complain(to.error(), exit_unavailable);
  const Result<std::optional<wire::ClientKeys>> keys = client::keys_from(to->key);
  if (!keys) return complain(keys.error(), exit_usage);
  RealExecutor executor;
  client::Contexts contexts(executor, prompt_name(), *keys, answers_within);
  std::vector<CellSight> cells;
  const Job looking = executor.spawn(look_into(&cells, executor, contexts, to->address));
  executor.run_until([&looking] { return looking.done(); });
  if (!choices.json) fmt::print("{:<20} {:>6}  {:<36} {:<24} {}\n", "CELL", "AGENTS", "GOAL", "ARMS", "STOPPED BY");
  for (const CellSight& cell : cells) choices.json ? fmt::print("{}\n", json_of(cell)) : print_cell(cell);
  return std::ranges::any_of(cells, [](const CellSight& cell) { return cell.fault.has_value(); }) ? exit_failed
                                                                                                  : exit_reached;
}

}  // namespace

void add_cells_command(CLI::App& app, int& status) {
  auto choices = std::make_shared<CellsChoices>();
  CLI::App* cells = app.add_subcommand(
      "cells", "Show how the cells do that a hall's board names: who is there, the goal, the arms, what stops them.");
  cells->add_flag("--json", choices->json, "Print one JSON object a line");
  add_board_options(cells, choices->board);
  cells->footer(help_footer("cells --board tcp://hall:7943"));
  cells->callback([choices, &status] { status = run_cells(*choices); });
}

}  // namespace pizarra::programs
