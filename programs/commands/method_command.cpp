// `method`: Divide, Wrap, Connect on a cell file, a description, a running board or a journal.

#include <fmt/format.h>
#include <fstream>
#include <sstream>
#include <unistd.h>

#include "agents/console/console_contract.hpp"
#include "agents/launcher/local_cell.hpp"
#include "agents/launcher/readiness.hpp"
#include "blackboard/client/keyed_board.hpp"
#include "blackboard/client/remote_board.hpp"
#include "blackboard/time/real_executor.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "lisp/reader.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/command_line/key_option.hpp"
#include "programs/commands/board_session.hpp"
#include "programs/commands/commands.hpp"
#include "programs/commands/live_traffic.hpp"
#include "programs/method/report.hpp"

namespace pizarra::programs {

namespace {

// Until every agent of a cell that comes up has told its contract and found whom it asks.
constexpr Duration coming_up = 5s;

struct MethodChoices {
  BoardChoices board;
  std::string file;  // a cell or a description
  bool live = false;
  std::string duration = "10s";
  std::string journal;
  std::string components;
  bool json = false;
  std::vector<std::string> svg;  // a file, or none: standard output
  bool draws = false;
};

std::string duration_fault(const std::string& text) {
  const bool in_seconds = text.ends_with('s');
  const std::string number = in_seconds ? text.substr(0, text.size() - 1) : text;
  return number_check(0.5, 86'400)(number).empty() ? "" : "a time is 0.5s to 86400s, not " + text;
}

Duration duration_from(const std::string& text) { return Duration(static_cast<std::int64_t>(std::stod(text) * 1e6)); }

// As the contracts say it: what each agent posts, and whom it asks in which role.
Task<void> read_contracts(Board& board, method::Traffic& traffic) {
  const Datum any = "?"_sym;
  const Datum patterns[] = {list("agent"_sym, any, any, any), list("contract"_sym, any, any)};
  for (const Datum& pattern : patterns) {
    const Result<std::vector<Fact>> facts = co_await board.facts(pattern);
    if (!facts) co_return;
    for (const Fact& fact : *facts) method::see_agent(traffic, fact.datum);
  }
  const Result<std::vector<Fact>> streams = co_await board.facts(list("stream"_sym, any, any, any));
  for (const Fact& fact : streams.value_or(std::vector<Fact>())) method::see_stream(traffic, fact);
  const Datum holders = list("holder"_sym, any, any, any, any);
  const Result<std::vector<Fact>> served = co_await board.facts(holders);
  if (!served) co_return;
  for (const Fact& fact : *served) {
    const Datum& holder = fact.datum;
    traffic.exchanges[{std::string(holder[1].text()), std::string(holder[3].text()), std::string(holder[2].text())}];
  }
}

Result<method::Traffic> traffic_of_cell(const std::string& file) {
  Result<forms::CellDescription> cell = forms::read_cell_file(file);
  if (!cell) return fail(cell);
  // Contracts are the same with whatever devices.
  cell->arm_line = {};
  if (cell->slave) cell->slave->line = {};
  cell->eyes = {};
  cell->objects_directory.clear();
  const Result<simulation::WorldConfig> sound = launcher::world_config(*cell, 1);
  if (!sound) return fail(sound);
  method::Traffic traffic;
  traffic.name = cell->name;
  const std::vector<std::string> agents = launcher::named_agents(*cell);
  VirtualExecutor executor;
  launcher::LocalCell local(executor, std::move(*cell), 1);
  for (const std::string& agent : agents) {
    const Result<void> started = local.start(agent);
    if (!started) return fail(started);
  }
  executor.run_for(coming_up);
  const std::unique_ptr<Board> board = local.board().view("method");
  const Job read = executor.spawn(read_contracts(*board, traffic));
  executor.run_until([&read] { return read.done(); });
  for (const auto& [name, agent] : traffic.agents) {
    for (const std::string& relation : method::names_in(agent.contract, "posts")) {
      traffic.flows[relation].told[name] = 0;
    }
  }
  return traffic;
}

Result<method::Traffic> traffic_of_file(const std::string& path) {
  std::ifstream in(path);
  std::ostringstream text;
  text << in.rdbuf();
  if (!in) return fail("unreadable-file", "the journal cannot be read: " + path);
  Result<method::Traffic> traffic = method::traffic_of_journal(text.str());
  if (traffic) traffic->name = path;
  return traffic;
}

Task<void> look_at(LiveLook& look, Duration duration, Result<method::Traffic>& traffic) {
  Result<method::Traffic> seen = co_await look.at(duration);
  traffic = std::move(seen);
}

Result<method::Traffic> traffic_of_board(const Destination& to, const std::optional<wire::ClientKeys>& keys,
                                         Duration duration) {
  RealExecutor executor;
  const std::string name = fmt::format("{}{}", LiveLook::names_begin, getpid());
  const auto connect = [&](const std::string& as) -> Result<std::unique_ptr<Board>> {
    auto board = client::RemoteBoard::connect(executor, to.address, as, client::RemoteBoard::default_timeout, keys);
    if (!board) return fail(board);
    return std::unique_ptr<Board>(std::move(*board));
  };
  const Result<std::unique_ptr<Board>> board = connect(name);
  if (!board) return fail(board);
  Result<method::Traffic> traffic = fail("unreachable", "the board did not answer");
  LiveLook look(executor, **board, name, connect);
  const Job job = executor.spawn(look_at(look, duration, traffic));
  executor.run_until([&job] { return job.done(); });
  if (traffic) traffic->name = to.run ? to.run->cell : to.address;
  if (look.cut()) fmt::print(stderr, "pizarra: of the requests only the first {} were counted\n", look.most_facts);
  return traffic;
}

// A page of the console may be opened at any time.
void read_by_pages(method::Traffic& traffic) {
  const Datum contract = list("contract"_sym, "console"_sym, read_one(console::reads_of_pages).value());
  for (const std::string& relation : method::names_in(contract, "reads")) {
    traffic.flows[relation].askers.insert("console");
  }
}

int show(const MethodChoices& choices, const method::Report& report) {
  if (choices.draws && !choices.svg.empty()) {
    std::ofstream out(choices.svg.front());
    out << method::svg_of(report.system);
    out.close();
    if (!out) {
      return complain(Failure{"unwritten", "the picture cannot be written: " + choices.svg.front(), {}, {}},
                      exit_failed);
    }
  } else if (choices.draws) {
    fmt::print("{}", method::svg_of(report.system));
    return exit_reached;
  }
  fmt::print("{}", choices.json ? method::json_of(report) + "\n" : method::text_of(report));
  return exit_reached;
}

int run_method(const MethodChoices& choices) {
  const int sources = (choices.file.empty() ? 0 : 1) + (choices.live ? 1 : 0) + (choices.journal.empty() ? 0 : 1);
  if (sources != 1) {
    return complain(Failure{"malformed", "name one: a CELL or description file, --live, or --journal FILE", {}, {}},
                    exit_usage);
  }
  if (!choices.file.empty() && method::is_system_file(choices.file)) {
    Result<method::System> system = method::read_system(choices.file);
    if (!system) return complain(system.error(), exit_usage);
    return show(choices, method::report_on(std::move(*system)));
  }
  const auto kinds = method::known_components(choices.components);
  if (!kinds) return complain(kinds.error(), exit_usage);
  const auto lists = method::known_wrapped();
  if (!lists) return complain(lists.error(), exit_failed);
  Result<method::Traffic> traffic = fail("no-traffic", "nothing was looked at");
  if (choices.live) {
    const Result<Destination> to = destination(choices.board);
    if (!to) return complain(to.error(), exit_unavailable);
    const Result<std::optional<wire::ClientKeys>> keys = client::keys_from(to->key);
    if (!keys) return complain(keys.error(), exit_usage);
    traffic = traffic_of_board(*to, *keys, duration_from(choices.duration));
    if (!traffic) return complain_of_board(repl::Style::text, traffic.error());
  } else {
    traffic = choices.journal.empty() ? traffic_of_cell(choices.file) : traffic_of_file(choices.journal);
    if (!traffic) return complain(traffic.error(), exit_usage);
  }
  read_by_pages(*traffic);
  return show(choices, method::report_on(*traffic, *kinds, *lists));
}

}  // namespace

void add_method_command(CLI::App& app, int& status) {
  auto choices = std::make_shared<MethodChoices>();
  CLI::App* method = app.add_subcommand(
      "method", "Divide, Wrap, Connect: indices, patterns and faults of a cell, as written or as it runs.");
  method->add_option("CELL", choices->file, "A cell file, or a description of components")->check(CLI::ExistingFile);
  method->add_flag("--live", choices->live, "Look at a running board instead of a file");
  method->add_option("--for", choices->duration, "With --live: how long to look")
      ->check(duration_fault)
      ->capture_default_str();
  method->add_option("--journal", choices->journal, "Look at this journal, written by demo --journal")
      ->check(CLI::ExistingFile);
  method
      ->add_option("--components", choices->components,
                   "A file that describes other kinds of agents: (component KIND PART ...)")
      ->check(CLI::ExistingFile);
  method->add_flag("--json", choices->json, "Print one JSON object");
  CLI::Option* svg = method->add_option("--svg", choices->svg,
                                        "Write the connections as a picture to this file; default: standard output");
  svg->expected(0, 1)->type_name("FILE");
  add_board_options(method, choices->board);
  method->footer(help_footer("method --live --for 60s"));
  method->callback([choices, svg, &status] {
    choices->draws = svg->count() > 0;
    std::erase(choices->svg, "");
    status = run_method(*choices);
  });
}

}  // namespace pizarra::programs
