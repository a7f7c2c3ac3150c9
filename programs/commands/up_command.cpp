// `up`: a cell as processes around a board.

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <unistd.h>

#include "agents/launcher/agent_factory.hpp"
#include "agents/launcher/run_directory.hpp"
#include "agents/launcher/supervisor.hpp"
#include "blackboard/client/keyed_board.hpp"
#include "blackboard/journal/journal_file.hpp"
#include "blackboard/streams/listen_address.hpp"
#include "blackboard/time/real_executor.hpp"
#include "lisp/forms/cell_file.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/command_line/key_option.hpp"
#include "programs/commands/commands.hpp"
#include "programs/commands/host_presence.hpp"
#include "programs/commands/line_pipe.hpp"
#include "programs/commands/log_member.hpp"
#include "programs/commands/this_host.hpp"
#include "programs/story/narrator.hpp"
#include "programs/story/scenario_run.hpp"

namespace pizarra::programs {

namespace {

struct UpChoices {
  std::string cell;
  std::string host;
  std::string board;
  std::string key;
  std::string keys;
  std::string world;
  std::string log;
  std::string certificates;
  std::string standby;
  std::string log_here;
  std::string log_folder;
  bool log_insecure = false;
  std::uint64_t seed = 1;
  bool json = false;
  bool console = false;
};

// What would have no effect is refused; a key of the environment is there for other words, too.
Result<void> check_keys(const UpChoices& choices, const forms::CellDescription& cell, const forms::CellHost& host) {
  // Boards that take over from each other are everybody's, and are come to by their addresses alone.
  if (!choices.log.empty()) return {};
  const bool owns_board = host.name == cell.board_host && choices.board.empty();
  const char* environment = std::getenv("PIZARRA_KEY");
  const bool key_typed = !choices.key.empty() && (environment == nullptr || choices.key != environment);
  if (owns_board && key_typed) {
    return fail("bad-option", fmt::format("--key is for a host that comes to the board of another, and {} has the "
                                          "cell's board itself: leave it out",
                                          host.name));
  }
  if (choices.keys.empty() || (owns_board && !cell.board_address.empty())) return {};
  return fail("bad-option",
              owns_board ? "--keys is for a board that other machines reach, and the cell file names no such address"
                         : "--keys is for the host of the cell's board, and this host does not run it");
}

// With these a board ends that will not do better next time: wrong arguments, address or journal; and an agent: a cell
// file or a key that cannot be read, a board with relations of another shape.
const std::vector<int> hopeless_board{2, 3, 4};
const std::vector<int> hopeless_agent{exit_usage};

std::string first_address(const std::string& addresses) { return addresses.substr(0, addresses.find(',')); }

std::string last_line_of(const std::string& file) {
  std::ifstream in(file);
  std::string last;
  for (std::string line; std::getline(in, line);) {
    if (!line.empty()) last = line;
  }
  return last;
}

class Up {
 public:
  Up(const UpChoices& choices, forms::CellDescription cell, forms::CellHost host, launcher::RunDirectory directory)
      : choices_(choices),
        cell_(std::move(cell)),
        host_(std::move(host)),
        directory_(std::move(directory)),
        narrator_(stdout, story::Narrator::style_for(stdout, choices.json)),
        supervisor_(executor_, [this](const launcher::ProcessEvent& event) { on_process(event); }) {}
  int run();

 private:
  void choose_board();
  Result<void> start_log();
  Result<void> start_board();
  Result<void> start_all();
  Result<void> find_world();
  Result<void> start_console(const std::string& cell);
  Result<void> start(const std::string& name, std::vector<std::string> command);
  Result<void> start_plugins();
  Result<void> start_door();
  std::string cell_path() const { return std::filesystem::absolute(choices_.cell).string(); }
  std::string device_address(const std::string& kind) const;
  Result<void> start_scheme_agent(const forms::CellSchemeAgent& agent);
  void on_process(const launcher::ProcessEvent& event);
  void save_state();

  const UpChoices& choices_;
  forms::CellDescription cell_;
  forms::CellHost host_;
  launcher::RunDirectory directory_;
  RealExecutor executor_;
  story::Narrator narrator_;
  std::string board_address_;
  std::string world_address_;
  std::string keys_;  // the folder of those that may come to this host's board
  std::string key_;   // with which this host comes to a board elsewhere
  std::string board_failure_;
  std::unique_ptr<LinePipe> addresses_;  // of the console
  launcher::Supervisor supervisor_;
};

Result<void> Up::start(const std::string& name, std::vector<std::string> command) {
  const std::vector<int>& final_statuses = name == "board" ? hopeless_board : hopeless_agent;
  return supervisor_.start({name, std::move(command), directory_.file(name + ".log"), final_statuses});
}

// Where the agent's device is, where that is not on a line of its own.
std::string Up::device_address(const std::string& kind) const {
  const launcher::DevicePlugin plugin = launcher::plugin_of(kind, cell_);
  return plugin.library.empty() ? world_address_
                                : fmt::format("ipc://{}", directory_.file(plugin.device + "-plugin.ipc"));
}

// Each runs where the agent of its device does.
Result<void> Up::start_plugins() {
  for (const std::string kind : {"robot", "vision"}) {
    const launcher::DevicePlugin plugin = launcher::plugin_of(kind, cell_);
    if (plugin.library.empty() || std::ranges::count(host_.agents, kind, launcher::kind_of_agent) == 0) continue;
    const Result<void> started = start(plugin.device + "-plugin", {beside_this_program("pizarra-plugin"), plugin.device,
                                                                   plugin.library, "--listen", device_address(kind)});
    if (!started) return started;
  }
  return {};
}

// Where the board asks for keys, its devices come with their own.
Result<void> Up::start_door() {
  if (!cell_.door || host_.name != cell_.board_host) return {};
  const std::string& board = keys_.empty() ? board_address_ : cell_.board_address;
  std::vector<std::string> command = {beside_this_program("pizarra-door"),
                                      "door",
                                      "--board",
                                      board,
                                      "--keys",
                                      std::filesystem::absolute(cell_.door->keys).string()};
  if (cell_.door->tcp_port)
    command.insert(command.end(), {"--tcp", fmt::format("127.0.0.1:{}", *cell_.door->tcp_port)});
  for (const forms::CellDoor::Line& line : cell_.door->lines) {
    command.insert(command.end(), {"--serial", fmt::format("{}:{}", line.file, line.baud)});
  }
  return start("door", std::move(command));
}

// An agent with a key of its own joins with it at the address that asks for keys, also on the board's own host.
Result<void> Up::start_scheme_agent(const forms::CellSchemeAgent& agent) {
  const bool own_key = !agent.key.empty();
  const std::string& key = own_key ? agent.key : key_;
  const std::string& board = own_key && !keys_.empty() ? cell_.board_address : board_address_;
  std::vector<std::string> command = {beside_this_program("pizarra-scheme"),
                                      "scheme",
                                      std::filesystem::absolute(agent.file).string(),
                                      "--name",
                                      agent.name,
                                      "--board",
                                      board,
                                      "--host",
                                      host_.name,
                                      "--time",
                                      std::to_string(agent.time_ms),
                                      "--memory",
                                      std::to_string(agent.memory_mb),
                                      "--rate",
                                      fmt::format("{:g}", agent.messages_per_s)};
  if (!key.empty()) command.insert(command.end(), {"--key", std::filesystem::absolute(key).string()});
  return start(agent.name, std::move(command));
}

// The world runs beside the board's host; others of this machine find it by that host's state.
Result<void> Up::find_world() {
  world_address_ = choices_.world.empty() ? "ipc://" + directory_.file("world.ipc") : choices_.world;
  if (host_.name == cell_.board_host || !choices_.world.empty()) return {};
  for (const launcher::RunState& run : launcher::running_cells()) {
    if (run.cell != cell_.name || run.host != cell_.board_host) continue;
    world_address_ = run.world_address;
    return {};
  }
  for (const std::string& kind : host_.agents) {
    if (!launcher::needs_world(kind, cell_) || device_address(kind) != world_address_) continue;
    return fail("no-world", fmt::format("{} needs the simulated world, and that runs on {}, which is not up on this "
                                        "machine: give {} to that host, or start that host here first",
                                        kind, cell_.board_host, kind));
  }
  return {};
}

// This host's part of the log, where it has one.
Result<void> Up::start_log() {
  if (choices_.log_here.empty()) return {};
  const Result<cluster::LogAddress> log =
      cluster::LogAddress::from(choices_.log, choices_.certificates, choices_.log_insecure);
  if (!log) return fail(log);
  Result<std::vector<std::string>> command = log_member(*log, choices_.log_here, choices_.log_folder);
  if (!command) return fail(command);
  return start("log", std::move(*command));
}

Result<void> Up::start_board() {
  const bool owns_board = host_.name == cell_.board_host && choices_.board.empty();
  std::vector<std::string> command = {beside_this_program("pizarra-board")};
  if (!choices_.log.empty()) {
    const std::string first = first_address(board_address_);
    const std::string listens_at = owns_board ? first : choices_.standby;
    if (listens_at.empty()) return {};
    command.insert(command.end(), {"--listen", listens_at, "--log", choices_.log, "--name", host_.name, "--past",
                                   directory_.file("past")});
    if (!choices_.certificates.empty()) command.insert(command.end(), {"--log-certificates", choices_.certificates});
    if (choices_.log_insecure) command.push_back("--log-insecure");
    if (!keys_.empty()) command.insert(command.end(), {"--keys", keys_});
    return start("board", std::move(command));
  }
  if (!owns_board) return {};
  // Only what is durable outlives the board; it is kept as long as the run's folder is.
  const std::string journal = directory_.file("board.journal");
  journal::remove_journal(journal);
  command.insert(command.end(), {"--listen", board_address_, "--journal", journal});
  if (!keys_.empty()) command.insert(command.end(), {"--listen", cell_.board_address, "--keys", keys_});
  return start("board", std::move(command));
}

Result<void> Up::start_all() {
  const std::string program = beside_this_program("pizarra-agent");
  const std::string seed = std::to_string(choices_.seed);
  const std::string cell = cell_path();
  const Result<void> log = start_log();
  if (!log) return log;
  const Result<void> board = start_board();
  if (!board) return board;
  if (host_.name == cell_.board_host) {
    const Result<void> world = start("world", {program, "world", cell, "--listen", world_address_, "--seed", seed});
    if (!world) return world;
  }
  const Result<void> plugins = start_plugins();
  if (!plugins) return plugins;
  const Result<void> door = start_door();
  if (!door) return door;
  for (const std::string& kind : host_.agents) {
    if (const forms::CellSchemeAgent* scheme = forms::scheme_agent_called(cell_, kind)) {
      const Result<void> agent = start_scheme_agent(*scheme);
      if (!agent) return agent;
      continue;
    }
    std::vector<std::string> command = {program,   "agent",        kind,      cell,
                                        "--board", board_address_, "--world", device_address(kind),
                                        "--host",  host_.name,     "--seed",  seed};
    if (!key_.empty()) command.insert(command.end(), {"--key", key_});
    const bool watched_elsewhere = launcher::kind_of_agent(kind) == "vision" && cell_.hosts.size() > 1;
    const std::string streams =
        watched_elsewhere ? streams::stream_listen_address(first_address(cell_.board_address)) : std::string();
    if (!streams.empty()) command.insert(command.end(), {"--streams", streams});
    const Result<void> agent = start(kind, std::move(command));
    if (!agent) return agent;
  }
  return choices_.console ? start_console(cell) : Result<void>();
}

// Its address holds a secret: it comes through a pipe of our own, and on no board.
Result<void> Up::start_console(const std::string& cell) {
  const std::string path = directory_.file("console.addresses");
  auto pipe = LinePipe::make(
      executor_, path, [this](const std::string& address) { narrator_.say(executor_.now(), "console", address); });
  if (!pipe) return fail(pipe);
  addresses_ = std::move(*pipe);
  // They belong to the journal, which is begun anew.
  const std::string pictures = directory_.file("pictures");
  std::error_code error;
  std::filesystem::remove_all(pictures, error);
  std::vector<std::string> command = {beside_this_program("pizarra-cell"),
                                      "console",
                                      cell,
                                      "--board",
                                      board_address_,
                                      "--addresses",
                                      path,
                                      "--pictures",
                                      pictures};
  if (!key_.empty()) command.insert(command.end(), {"--key", key_});
  return start("console", std::move(command));
}

void Up::on_process(const launcher::ProcessEvent& event) {
  narrator_.say(executor_.now(), "process", fmt::format("{} {}", event.name, event.sentence));
  save_state();
  if (!event.given_up) return;
  const std::string last_words = last_line_of(directory_.file(event.name + ".log"));
  if (event.name != "board") return narrator_.say(executor_.now(), "failure", event.name + ": " + last_words);
  board_failure_ = last_words;
  supervisor_.stop();
}

void Up::save_state() {
  launcher::RunState state{cell_.name, host_.name, getpid(), board_address_, world_address_, key_, cell_path(), {}};
  for (const launcher::Supervisor::Process& process : supervisor_.processes()) {
    state.processes.push_back({process.name, process.pid, process.restarts});
  }
  const Result<void> saved = directory_.save(state);
  if (!saved) narrator_.say(executor_.now(), "failure", describe(saved.error()));
}

// With keys the board's own host needs none: it comes over a file of its own.
void Up::choose_board() {
  const std::string own_address = "ipc://" + directory_.file("board.ipc");
  const bool owns_board = host_.name == cell_.board_host && choices_.board.empty();
  const std::string folder = choices_.keys.empty() ? cell_.board_keys : choices_.keys;
  if (owns_board && !cell_.board_address.empty()) keys_ = folder;
  board_address_ = !choices_.board.empty()                         ? choices_.board
                   : cell_.board_address.empty() || !keys_.empty() ? own_address
                                                                   : cell_.board_address;
  const std::string key = choices_.key.empty() ? host_.key : choices_.key;
  const bool shared = !choices_.log.empty();
  if (shared && !cell_.board_address.empty()) board_address_ = cell_.board_address;
  if (shared && (owns_board || !choices_.standby.empty())) keys_ = folder;
  if ((shared || !owns_board) && !key.empty()) key_ = std::filesystem::absolute(key).string();
}

int Up::run() {
  narrator_.begin(executor_.now());
  choose_board();
  const Result<void> world = find_world();
  if (!world) return complain(world.error(), exit_usage);
  Result<std::unique_ptr<client::RemoteBoard>> ears = client::keyed_board(executor_, board_address_, key_, "narrator");
  if (!ears) return complain(ears.error(), exit_usage);
  const Result<void> started = start_all();
  if (!started) {
    supervisor_.stop();
    executor_.run_until([this] { return supervisor_.stopped(); });
    return complain(started.error(), exit_unavailable);
  }
  save_state();
  narrator_.say(executor_.now(), "board", board_address_);
  narrator_.say(executor_.now(), "logs", directory_.path());
  {
    const Job told = executor_.spawn(narrator_.follow(**ears, executor_));
    const Processes processes = [this] { return supervisor_.processes(); };
    const Job present = executor_.spawn(tell_host(**ears, executor_, host_.name, processes));
    executor_.run_until([this] { return supervisor_.stopping(); });
  }
  narrator_.say(executor_.now(), "process", "stopping");
  executor_.run_until([this] { return supervisor_.stopped(); });
  directory_.remove_state();
  if (!board_failure_.empty()) {
    return complain(Failure{"no-board", "the board cannot be started: " + board_failure_, {}, {}}, exit_unavailable);
  }
  return exit_reached;
}

int run_up(const UpChoices& choices) {
  Result<forms::CellDescription> cell = forms::read_cell_file(choices.cell);
  if (!cell) return complain(cell.error(), exit_usage);
  const Result<simulation::WorldConfig> sound = launcher::world_config(*cell, choices.seed);
  if (!sound) return complain(sound.error(), exit_usage);
  if (story::needs_domain(*cell)) {
    const Result<forms::Domain> domain = story::domain_of(*cell);
    if (!domain) return complain(domain.error(), exit_usage);
  }
  Result<forms::CellHost> host = choose_host(*cell, choices.host);
  if (!host) return complain(host.error(), exit_usage);
  const Result<void> effective = check_keys(choices, *cell, *host);
  if (!effective) return complain(effective.error(), exit_usage);
  Result<launcher::RunDirectory> directory = launcher::RunDirectory::make(cell->name, host->name);
  if (!directory) return complain(directory.error(), exit_unavailable);
  return Up(choices, std::move(*cell), std::move(*host), std::move(*directory)).run();
}

}  // namespace

void add_up_command(CLI::App& app, int& status) {
  auto choices = std::make_shared<UpChoices>();
  CLI::App* up = app.add_subcommand(
      "up", "Run the agents that a cell file gives to this host, as processes around a board; Ctrl-C stops them all.");
  up->add_option("CELL", choices->cell, "The cell file")->required()->check(CLI::ExistingFile);
  up->add_option("--host", choices->host, "The name of this host in the cell file");
  up->add_option("--board", choices->board, "Use this board, which runs already, instead of starting the cell's");
  up->add_option("--keys", choices->keys, "The folder of the keys that this host's board lets in; default: the cell's");
  add_key_option(up, choices->key);
  up->add_option("--world", choices->world,
                 "The simulated world's address, ipc://PATH; default: in the run's folder. For hosts that share a file")
      ->envname("PIZARRA_WORLD");
  CLI::Option* log = up->add_option("--log", choices->log,
                                    "Keep what is durable in an etcd cluster, etcd://A,B,C/CELL, so that another board "
                                    "takes over when this one is gone");
  up->add_option("--log-certificates", choices->certificates,
                 "The folder of ca.crt, client.crt and client.key for that cluster")
      ->needs(log);
  up->add_flag("--log-insecure", choices->log_insecure, "Connect to that cluster without encryption")->needs(log);
  up->add_option("--standby", choices->standby, "Also run a board on this host, at this address of the cell")
      ->needs(log);
  CLI::Option* log_here =
      up->add_option("--log-here", choices->log_here,
                     "Run an etcd member of that cluster on this host: which address of --log it has")
          ->needs(log)
          ->type_name("ADDRESS");
  CLI::Option* log_folder =
      up->add_option("--log-folder", choices->log_folder, "Where that member keeps its data, on a disk that lasts")
          ->needs(log_here)
          ->type_name("DIR");
  log_here->needs(log_folder);
  up->add_option("--seed", choices->seed, "The seed of the simulated world")
      ->check(seed_check())
      ->capture_default_str();
  up->add_flag("--console", choices->console, "Also show the cell in a browser; the address is printed");
  up->add_flag("--json", choices->json, "Print one JSON object a line");
  up->footer(help_footer("up examples/01-blocks/cell.scm"));
  up->callback([choices, &status] { status = run_up(*choices); });
}

}  // namespace pizarra::programs
