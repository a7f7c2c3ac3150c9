// `ps`: the processes and agents of the cells that run here.

#include <algorithm>
#include <array>
#include <fmt/format.h>

#include "agents/launcher/run_directory.hpp"
#include "agents/runtime/declared.hpp"
#include "blackboard/client/keyed_board.hpp"
#include "blackboard/client/remote_board.hpp"
#include "blackboard/time/real_executor.hpp"
#include "lisp/json.hpp"
#include "lisp/outside_text.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/commands/commands.hpp"

namespace pizarra::programs {

namespace {

// Processes that tell the board of no agent.
constexpr std::array<std::string_view, 6> no_agents{"board", "world", "log", "door", "arm-plugin", "camera-plugin"};

struct OnBoard {
  std::vector<Fact> agents;
  std::vector<Fact> holders;   // (holder CLIENT ROLE SERVER STATE)
  std::vector<Fact> refusals;  // board-refusal
};

// The board's answer, or nothing where it does not come in time.
Task<void> list_facts(client::RemoteBoard& board, OnBoard* out) {
  Datum agent = list("agent"_sym, "?"_sym, "?"_sym, "?"_sym);
  Result<std::vector<Fact>> agents = co_await runtime::facts_if_declared(board, std::move(agent));
  if (agents) out->agents = std::move(*agents);
  if (!board.connected()) co_return;
  Datum holder = list("holder"_sym, "?"_sym, "?"_sym, "?"_sym, "?"_sym);
  Result<std::vector<Fact>> holders = co_await runtime::facts_if_declared(board, std::move(holder));
  if (holders) out->holders = std::move(*holders);
  Datum refusal = list("board-refusal"_sym, "?"_sym, "?"_sym, "?"_sym, "?"_sym);
  Result<std::vector<Fact>> refusals = co_await board.facts(std::move(refusal));
  if (refusals) out->refusals = std::move(*refusals);
}

OnBoard facts_on(const launcher::RunState& run) {
  RealExecutor executor;
  OnBoard facts;
  const auto board = client::keyed_board(executor, run.board_address, run.key, "ps", 2s);
  if (!board) return facts;
  const Job job = executor.spawn(list_facts(**board, &facts));
  executor.run_until([&job] { return job.done(); });
  return facts;
}

// Of (board-refusal CLIENT SYMBOL COUNT SENTENCE).
void print_refusal(const launcher::RunState& run, const Datum& refusal, bool json) {
  const std::string_view client = refusal[1].text();
  const std::int64_t count = refusal[3].integer();
  if (json) {
    fmt::print("{{\"cell\":{},\"refused\":{},\"symbol\":{},\"count\":{},\"newest\":{}}}\n", json_string(run.cell),
               json_string(client), json_string(refusal[2].text()), count, json_string(refusal[4].text()));
    return;
  }
  fmt::print("  refused {} {}, {}: {}\n", client.empty() ? "who said no hello" : client,
             counted(static_cast<std::size_t>(count), "time"), refusal[2].text(), text_of_bytes(refusal[4].text()));
}

void print_holder(const launcher::RunState& run, const Datum& holder, bool json) {
  if (json) {
    fmt::print("{{\"cell\":{},\"client\":{},\"role\":{},\"server\":{},\"state\":{}}}\n", json_string(run.cell),
               json_string(holder[1].text()), json_string(holder[2].text()), json_string(holder[3].text()),
               json_string(holder[4].text()));
    return;
  }
  const std::string_view state = holder[4].text();
  fmt::print("  {}'s {}: {}{}\n", holder[1].text(), holder[2].text(), holder[3].text(),
             state == "wired"    ? ""
             : state == "absent" ? ", who is absent"
                                 : ", who stands in");
}

void print_run(const launcher::RunState& run, bool json) {
  OnBoard on_board = facts_on(run);
  std::vector<Fact>& agents = on_board.agents;
  if (!json)
    fmt::print("cell {} on {}, process {}, board {}\n", run.cell, run.host, run.supervisor_pid, run.board_address);
  const auto print = [&](std::string_view name, std::string_view kind, std::string_view host,
                         const launcher::RunProcess* process) {
    if (json) {
      fmt::print("{{\"cell\":{},\"name\":{},\"kind\":{},\"host\":{},\"pid\":{},\"restarts\":{}}}\n",
                 json_string(run.cell), json_string(name), json_string(kind), json_string(host),
                 process ? process->pid : 0, process ? process->restarts : 0);
      return;
    }
    const std::string pid = process && process->pid != 0 ? std::to_string(process->pid) : "-";
    const auto restarts = static_cast<std::size_t>(process ? process->restarts : 0);
    fmt::print("  {:<14} {:<12} {:<12} {:>8}  {}\n", name, kind, host, pid, counted(restarts, "restart"));
  };
  for (const launcher::RunProcess& process : run.processes) {
    const auto fact =
        std::ranges::find_if(agents, [&](const Fact& agent) { return agent.datum[1].text() == process.name; });
    const std::string_view absent = std::ranges::count(no_agents, process.name) > 0 ? "" : "(absent)";
    print(process.name, fact == agents.end() ? absent : fact->datum[2].text(), run.host, &process);
    if (fact != agents.end()) agents.erase(fact);
  }
  for (const Fact& agent : agents) print(agent.datum[1].text(), agent.datum[2].text(), agent.datum[3].text(), nullptr);
  for (const Fact& holder : on_board.holders) print_holder(run, holder.datum, json);
  for (const Fact& refusal : on_board.refusals) print_refusal(run, refusal.datum, json);
}

int run_ps(bool json) {
  const std::vector<launcher::RunState> runs = launcher::running_cells();
  if (runs.empty() && !json) fmt::print("no cell runs here\n");
  for (const launcher::RunState& run : runs) print_run(run, json);
  return exit_reached;
}

}  // namespace

void add_ps_command(CLI::App& app, int& status) {
  auto json = std::make_shared<bool>(false);
  CLI::App* ps = app.add_subcommand("ps", "Show the processes and agents of the cells that run here.");
  ps->add_flag("--json", *json, "Print one JSON object a line");
  ps->footer(help_footer("ps --json"));
  ps->callback([json, &status] { status = run_ps(*json); });
}

}  // namespace pizarra::programs
