// `hosts`: what runs where in a cell, which hosts are there, and whose builds the board cannot speak with.

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "agents/runtime/declared.hpp"
#include "blackboard/boards_own.hpp"
#include "blackboard/client/keyed_board.hpp"
#include "blackboard/client/remote_board.hpp"
#include "blackboard/time/real_executor.hpp"
#include "lisp/forms/cell_file.hpp"
#include "lisp/json.hpp"
#include "lisp/outside_text.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/command_line/key_option.hpp"
#include "programs/commands/board_session.hpp"
#include "programs/commands/commands.hpp"

namespace pizarra::programs {

namespace {

struct HostsChoices {
  std::string cell;
  BoardChoices board;
  bool json = false;
};

struct HostsSeen {
  std::vector<Fact> hosts;      // (host NAME VERSION OFFSET-MS)
  std::vector<Fact> agents;     // (agent NAME KIND HOST)
  std::vector<Fact> processes;  // (process HOST NAME RUNNING RESTARTS NEWEST)
  std::vector<Fact> leaders;    // (board-leads NAME)
  std::vector<Fact> strangers;  // (board-refusal CLIENT other-protocol COUNT SENTENCE)
  std::optional<Failure> failure;
};

struct HostRow {
  std::string host;
  bool there = false;
  std::string version;
  std::optional<std::int64_t> offset_ms;
  std::vector<std::string> agents;     // that are there
  std::vector<std::string> absent;     // that the cell file gives to it
  bool leads = false;                  // its board does, of those that take over
  std::vector<std::string> down = {};  // its processes that do not run, each with what happened to it last
};

Task<std::vector<Fact>> facts_told(client::RemoteBoard& board, std::string_view relation, std::size_t arguments) {
  std::vector<Datum> pattern{Datum::symbol(relation)};
  pattern.resize(1 + arguments, "?"_sym);
  Datum any = Datum::list(std::move(pattern));
  Result<std::vector<Fact>> facts = co_await runtime::facts_if_declared(board, std::move(any));
  if (!facts) co_return std::vector<Fact>();
  co_return std::move(*facts);
}

Task<void> look_for_hosts(client::RemoteBoard& board, HostsSeen* seen) {
  Datum agent = list("agent"_sym, "?"_sym, "?"_sym, "?"_sym);
  Result<std::vector<Fact>> agents = co_await runtime::facts_if_declared(board, std::move(agent));
  if (!agents) {
    seen->failure = agents.error();
    co_return;
  }
  seen->agents = std::move(*agents);
  seen->hosts = co_await facts_told(board, "host", 3);
  seen->processes = co_await facts_told(board, "process", 5);
  seen->leaders = co_await facts_told(board, "board-leads", 1);
  Datum stranger = list("board-refusal"_sym, "?"_sym, "other-protocol"_sym, "?"_sym, "?"_sym);
  Result<std::vector<Fact>> strangers = co_await runtime::facts_if_declared(board, std::move(stranger));
  if (strangers) seen->strangers = std::move(*strangers);
}

HostRow& row_of(std::vector<HostRow>& rows, const std::string& host) {
  const auto found = std::ranges::find(rows, host, &HostRow::host);
  if (found != rows.end()) return *found;
  rows.emplace_back().host = host;
  return rows.back();
}

// Of the cell file's hosts, in its order, and then of others that agents came from.
std::vector<HostRow> rows_of(const std::optional<forms::CellDescription>& cell, const HostsSeen& seen) {
  std::vector<HostRow> rows;
  if (cell) {
    for (const forms::CellHost& host : cell->hosts) row_of(rows, host.name).absent = host.agents;
  }
  for (const Fact& fact : seen.hosts) {
    HostRow& row = row_of(rows, std::string(fact.datum[1].text()));
    row.there = true;
    row.version = fact.datum[2].text();
    row.offset_ms = fact.datum[3].integer();
  }
  for (const Fact& fact : seen.agents) {
    HostRow& row = row_of(rows, std::string(fact.datum[3].text()));
    row.agents.emplace_back(fact.datum[1].text());
    std::erase(row.absent, row.agents.back());
  }
  for (const Fact& fact : seen.processes) {
    const Datum& process = fact.datum;
    if (process[3].is_symbol("yes")) continue;
    row_of(rows, std::string(process[1].text()))
        .down.push_back(fmt::format("{}: {}", process[2].text(), process[5].text()));
  }
  for (const Fact& fact : seen.leaders) {
    if (fact.teller == board_teller) row_of(rows, std::string(fact.datum[1].text())).leads = true;
  }
  return rows;
}

std::string joined_names(const std::vector<std::string>& words) { return fmt::format("{}", fmt::join(words, " ")); }

std::string_view state_of(const HostRow& row) { return row.leads ? "leads" : row.there ? "there" : "away"; }

void print_host(const HostRow& row, bool json) {
  if (json) {
    const std::string offset = row.offset_ms ? std::to_string(*row.offset_ms) : "null";
    fmt::print(
        "{{\"host\":{},\"there\":{},\"leads\":{},\"version\":{},\"offset-ms\":{},\"agents\":{},\"absent\":{},"
        "\"down\":{}}}\n",
        json_string(row.host), row.there, row.leads, json_string(row.version), offset,
        json_string(joined_names(row.agents)), json_string(joined_names(row.absent)),
        json_string(fmt::format("{}", fmt::join(row.down, "\n"))));
    return;
  }
  const std::string offset = row.offset_ms ? fmt::format("{:+.3f} s", static_cast<double>(*row.offset_ms) / 1000) : "-";
  fmt::print("{:<16} {:<10} {:<10} {:>12}  {}{}\n", text_of_bytes(row.host), state_of(row),
             row.version.empty() ? "-" : row.version, offset, joined_names(row.agents),
             row.absent.empty() ? "" : "  (absent: " + joined_names(row.absent) + ")");
  for (const std::string& process : row.down) fmt::print("  {}\n", text_of_bytes(process));
}

// Of a host that is there since, it is over.
bool is_over(const Datum& refusal, const std::vector<HostRow>& rows) {
  const auto row = std::ranges::find(rows, refusal[1].text(), &HostRow::host);
  return row != rows.end() && row->there;
}

void print_stranger(const Datum& refusal, bool json) {
  const std::string_view client = refusal[1].text();
  if (json) {
    fmt::print("{{\"refused\":{},\"newest\":{}}}\n", json_string(client), json_string(refusal[4].text()));
    return;
  }
  fmt::print("refused {}: {}\n", client.empty() ? "who comes without a key" : client, text_of_bytes(refusal[4].text()));
}

// The board of a cell file, where none was named: as the `up` of that file comes to it, which may need a key, or else
// as the file says.
void choose_board(const std::string& file, const forms::CellDescription& cell, BoardChoices& board) {
  if (!board.board.empty()) return;
  board.board = cell.board_address;
  if (!board.key.empty()) return;
  const std::vector<launcher::RunState> runs = launcher::running_cells();
  const auto run = std::ranges::find(runs, std::filesystem::absolute(file).string(), &launcher::RunState::cell_file);
  if (run == runs.end()) return;
  board.board = run->board_address;
  board.key = run->key;
}

int run_hosts(HostsChoices choices) {
  std::optional<forms::CellDescription> cell;
  if (std::filesystem::is_regular_file(choices.cell)) {
    Result<forms::CellDescription> described = forms::read_cell_file(choices.cell);
    if (!described) return complain(described.error(), exit_usage);
    cell = std::move(*described);
    choose_board(choices.cell, *cell, choices.board);
  }
  choices.board.cell = cell ? cell->name : choices.cell;
  if (!choices.board.board.empty()) choices.board.cell.clear();
  const Result<Destination> to = destination(choices.board);
  if (!to) return complain(to.error(), exit_unavailable);
  RealExecutor executor;
  const auto board = client::keyed_board(executor, to->address, to->key, "hosts", 3s);
  if (!board) return complain(board.error(), exit_usage);
  HostsSeen seen;
  const Job job = executor.spawn(look_for_hosts(**board, &seen));
  executor.run_until([&job] { return job.done(); });
  if (seen.failure) return complain(*seen.failure, exit_unavailable);
  if (!choices.json) fmt::print("{:<16} {:<10} {:<10} {:>12}  {}\n", "HOST", "", "VERSION", "CLOCK", "AGENTS");
  const std::vector<HostRow> rows = rows_of(cell, seen);
  for (const HostRow& row : rows) print_host(row, choices.json);
  for (const Fact& fact : seen.strangers) {
    if (!is_over(fact.datum, rows)) print_stranger(fact.datum, choices.json);
  }
  return exit_reached;
}

}  // namespace

void add_hosts_command(CLI::App& app, int& status) {
  auto choices = std::make_shared<HostsChoices>();
  CLI::App* hosts = app.add_subcommand(
      "hosts", "Show what runs on which host of a cell, which hosts are there, their versions and clocks.");
  hosts->add_option("CELL", choices->cell,
                    "The cell file, or the name of a cell that runs here; default: the only one");
  hosts->add_option("--board", choices->board.board, "The board's address; default: the cell's");
  add_key_option(hosts, choices->board.key);
  hosts->add_flag("--json", choices->json, "Print one JSON object a line");
  hosts->footer(help_footer("hosts two-hosts.scm"));
  hosts->callback([choices, &status] { status = run_hosts(*choices); });
}

}  // namespace pizarra::programs
