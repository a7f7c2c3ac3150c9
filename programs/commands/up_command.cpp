// `up`: a cell as processes around a board.

#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <unistd.h>

#include "agents/launcher/agent_factory.hpp"
#include "agents/launcher/run_directory.hpp"
#include "agents/launcher/supervisor.hpp"
#include "blackboard/client/remote_board.hpp"
#include "blackboard/journal/journal_file.hpp"
#include "blackboard/streams/listen_address.hpp"
#include "blackboard/time/real_executor.hpp"
#include "lisp/forms/cell_file.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/command_line/key_option.hpp"
#include "programs/commands/commands.hpp"
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
  std::uint64_t seed = 1;
  bool json = false;
};

// What would have no effect is refused; a key of the environment is there for other words, too.
Result<void> check_keys(const UpChoices& choices, const forms::CellDescription& cell, const forms::CellHost& host) {
  const bool owns_board = host.name == cell.board_host && choices.board.empty();
  const char* environment = std::getenv("PIZARRA_KEY");
  const bool key_typed = !choices.key.empty() && (environment == nullptr || choices.key != environment);
  if (owns_board && key_typed) {
    return fail("bad-option", fmt::format("--key is for a host that comes to the board of another, and {} has the "
                                          "cell's board itself: leave it out",
                                          host.name));
  }
  if (choices.keys.empty() || (owns_board && !cell.board_address.empty())) return {};
  return fail("bad-option", owns_board ? "--keys says who may come to the cell's board from other machines, and the "
                                         "cell file gives it no address that they reach"
                                       : "--keys says who may come to the cell's board, and this host does not run it");
}

// With these a board ends that will not do better next time: wrong arguments, address or journal; and an agent: a cell
// file or a key that cannot be read, a board with relations of another shape.
const std::vector<int> hopeless_board{2, 3, 4};
const std::vector<int> hopeless_agent{exit_usage};

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
  Result<void> start_all();
  Result<void> find_world();
  Result<void> start(const std::string& name, std::vector<std::string> command);
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
  launcher::Supervisor supervisor_;
};

Result<void> Up::start(const std::string& name, std::vector<std::string> command) {
  const std::vector<int>& final_statuses = name == "board" ? hopeless_board : hopeless_agent;
  return supervisor_.start({name, std::move(command), directory_.file(name + ".log"), final_statuses});
}

// The world runs beside the board's host; others of this machine find it by that host's state.
Result<void> Up::find_world() {
  world_address_ = "ipc://" + directory_.file("world.ipc");
  if (host_.name == cell_.board_host) return {};
  for (const launcher::RunState& run : launcher::running_cells()) {
    if (run.cell != cell_.name || run.host != cell_.board_host) continue;
    world_address_ = run.world_address;
    return {};
  }
  for (const std::string& kind : host_.agents) {
    if (!launcher::needs_world(kind, cell_)) continue;
    return fail("no-world", fmt::format("{} needs the simulated world, and that runs on {}, which is not up on this "
                                        "machine: give {} to that host, or start that host here first",
                                        kind, cell_.board_host, kind));
  }
  return {};
}

Result<void> Up::start_all() {
  const std::string program = beside_this_program("pizarra-agent");
  const std::string seed = std::to_string(choices_.seed);
  const std::string cell = std::filesystem::absolute(choices_.cell).string();
  const bool owns_board = host_.name == cell_.board_host && choices_.board.empty();
  if (owns_board) {
    // Only what is durable outlives the board; it is kept as long as the run's folder is.
    const std::string journal = directory_.file("board.journal");
    journal::remove_journal(journal);
    std::vector<std::string> command = {beside_this_program("pizarra-board"), "--listen", board_address_, "--journal",
                                        journal};
    if (!keys_.empty()) command.insert(command.end(), {"--listen", cell_.board_address, "--keys", keys_});
    const Result<void> board = start("board", std::move(command));
    if (!board) return board;
  }
  if (host_.name == cell_.board_host) {
    const Result<void> world = start("world", {program, "world", cell, "--listen", world_address_, "--seed", seed});
    if (!world) return world;
  }
  for (const std::string& kind : host_.agents) {
    std::vector<std::string> command = {program,   "agent",        kind,     cell,       "--board", board_address_,
                                        "--world", world_address_, "--host", host_.name, "--seed",  seed};
    if (!key_.empty()) command.insert(command.end(), {"--key", key_});
    const bool watched_elsewhere = kind == "vision" && cell_.hosts.size() > 1;
    const std::string streams = watched_elsewhere ? streams::stream_listen_address(cell_.board_address) : std::string();
    if (!streams.empty()) command.insert(command.end(), {"--streams", streams});
    const Result<void> agent = start(kind, std::move(command));
    if (!agent) return agent;
  }
  return {};
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
  launcher::RunState state{cell_.name, host_.name, getpid(), board_address_, world_address_, key_, {}};
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
  if (!owns_board && !key.empty()) key_ = std::filesystem::absolute(key).string();
}

int Up::run() {
  narrator_.begin(executor_.now());
  choose_board();
  const Result<std::optional<wire::ClientKeys>> keys = keys_from(key_);
  if (!keys) return complain(keys.error(), exit_usage);
  const Result<void> world = find_world();
  if (!world) return complain(world.error(), exit_usage);
  Result<std::unique_ptr<client::RemoteBoard>> ears =
      client::RemoteBoard::connect(executor_, board_address_, "narrator", client::RemoteBoard::default_timeout, *keys);
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
    executor_.run_until([this] { return supervisor_.stopping(); });
  }
  narrator_.say(executor_.now(), "process", "stopping");
  executor_.run_until([this] { return supervisor_.stopped(); });
  directory_.remove_state();
  if (!board_failure_.empty()) {
    return complain(Failure{"no-board", "the board cannot be had: " + board_failure_, {}, {}}, exit_unavailable);
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
  up->add_option("--host", choices->host, "Which of the cell's hosts this is");
  up->add_option("--board", choices->board, "A board that runs already, in place of the cell's own");
  up->add_option("--keys", choices->keys,
                 "The folder of the keys that may come to this host's board; the cell's otherwise");
  add_key_option(up, choices->key);
  up->add_option("--seed", choices->seed, "What chance begins from in the simulated world")
      ->check(seed_check())
      ->capture_default_str();
  up->add_flag("--json", choices->json, "One JSON object a line");
  up->footer(help_footer("up examples/01-blocks/cell.scm"));
  up->callback([choices, &status] { status = run_up(*choices); });
}

}  // namespace pizarra::programs
