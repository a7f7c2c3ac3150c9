// `up`: a cell as processes around a board.

#include <filesystem>
#include <fmt/format.h>
#include <unistd.h>

#include "agents/launcher/agent_factory.hpp"
#include "agents/launcher/process_log.hpp"
#include "agents/launcher/run_directory.hpp"
#include "agents/launcher/supervisor.hpp"
#include "blackboard/client/keyed_board.hpp"
#include "blackboard/cluster/etcd_json.hpp"
#include "blackboard/journal/journal_file.hpp"
#include "blackboard/time/real_executor.hpp"
#include "lisp/forms/cell_file.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/command_line/key_option.hpp"
#include "programs/commands/commands.hpp"
#include "programs/commands/line_pipe.hpp"
#include "programs/host/host_places.hpp"
#include "programs/host/host_presence.hpp"
#include "programs/host/host_processes.hpp"
#include "programs/host/this_host.hpp"
#include "programs/host/up_choices.hpp"
#include "programs/story/narrator.hpp"
#include "programs/story/scenario_run.hpp"

namespace pizarra::programs {

namespace {

// With these a board ends that will not do better next time: wrong arguments, address or journal; and an agent: a cell
// file or a key that cannot be read, a board with relations of another shape.
const std::vector<int> hopeless_board{2, 3, 4};
const std::vector<int> hopeless_agent{exit_usage};
// Other hosts lead meanwhile, and the address may become free.
const std::vector<int> hopeless_among_boards{2, 4};
// Etcd ends with any, also where its disk was full.
const std::vector<int> hopeless_log;

class Up {
 public:
  Up(const host::UpChoices& choices, forms::CellDescription cell, forms::CellHost host,
     launcher::RunDirectory directory)
      : choices_(choices),
        cell_(std::move(cell)),
        host_(std::move(host)),
        directory_(std::move(directory)),
        narrator_(stdout, story::Narrator::style_for(stdout, choices.json)),
        supervisor_(executor_, [this](const launcher::ProcessEvent& event) { on_process(event); }) {}
  int run();

 private:
  Result<void> start_all();
  Result<void> start_console();
  // Neither a board elsewhere nor a log keeps what was.
  bool begins_anew() const { return places_.owns_board && choices_.log.empty(); }
  // With the log, or one of its boards: it is started again as long as this host is up.
  bool serves_other_hosts(const std::string& name) const {
    return !choices_.log_here.empty() && (name == "log" || name == "board");
  }
  const std::vector<int>& final_statuses_of(const std::string& name) const;
  Result<void> start(host::HostProcess process);
  int run_until_stopped(client::RemoteBoard& ears);
  void on_process(const launcher::ProcessEvent& event);
  void save_state();

  const host::UpChoices& choices_;
  forms::CellDescription cell_;
  forms::CellHost host_;
  launcher::RunDirectory directory_;
  RealExecutor executor_;
  story::Narrator narrator_;
  host::HostPlaces places_;
  std::string board_failure_;
  std::unique_ptr<LinePipe> addresses_;  // of the console
  launcher::Supervisor supervisor_;
};

const std::vector<int>& Up::final_statuses_of(const std::string& name) const {
  if (name == "log") return hopeless_log;
  if (name != "board") return hopeless_agent;
  return serves_other_hosts(name) ? hopeless_among_boards : hopeless_board;
}

Result<void> Up::start(host::HostProcess process) {
  const std::string log = directory_.file(launcher::process_log_name(process.name));
  return supervisor_.start({process.name, std::move(process.command), log, final_statuses_of(process.name),
                            process.niceness, !serves_other_hosts(process.name)});
}

Result<void> Up::start_all() {
  Result<std::vector<host::HostProcess>> processes = host::host_processes(choices_, cell_, host_, places_, directory_);
  if (!processes) return fail(processes);
  // Only what is durable outlives the board; it is kept as long as the run's folder is.
  if (begins_anew()) journal::remove_journal(directory_.file("board.journal"));
  for (host::HostProcess& process : *processes) {
    const Result<void> started = start(std::move(process));
    if (!started) return started;
  }
  return choices_.console ? start_console() : Result<void>();
}

// Its address holds a secret: it comes through a pipe of our own, and on no board.
Result<void> Up::start_console() {
  const std::string path = directory_.file("console.addresses");
  auto pipe = LinePipe::make(
      executor_, path, [this](const std::string& address) { narrator_.say(executor_.now(), "console", address); });
  if (!pipe) return fail(pipe);
  addresses_ = std::move(*pipe);
  const std::string pictures = directory_.file("pictures");
  std::error_code error;
  // Pictures of a journal that is begun anew show nothing that can be asked for.
  if (begins_anew()) std::filesystem::remove_all(pictures, error);
  if (error) return fail("cannot-write", fmt::format("cannot remove {}: {}", pictures, error.message()));
  return start(host::console_process(choices_, places_, path, pictures));
}

void Up::on_process(const launcher::ProcessEvent& event) {
  narrator_.say(executor_.now(), "process", fmt::format("{} {}", event.name, event.sentence));
  save_state();
  const bool has_failed = event.given_up || (event.ended && serves_other_hosts(event.name));
  if (!has_failed) return;
  const std::string last_words = launcher::last_line_of_log(directory_.file(launcher::process_log_name(event.name)));
  if (event.name != "board" || serves_other_hosts(event.name)) {
    const std::string why = event.name == "log" ? cluster::etcd_json::news_from(last_words) : last_words;
    return narrator_.say(executor_.now(), "failure", event.name + ": " + why);
  }
  board_failure_ = last_words;
  supervisor_.stop();
}

void Up::save_state() {
  launcher::RunState state{cell_.name,
                           host_.name,
                           getpid(),
                           places_.board,
                           places_.world,
                           places_.key,
                           std::filesystem::absolute(choices_.cell).string(),
                           {}};
  for (const launcher::Supervisor::Process& process : supervisor_.processes()) {
    state.processes.push_back({process.name, process.pid, process.restarts});
  }
  const Result<void> saved = directory_.save(state);
  if (!saved) narrator_.say(executor_.now(), "failure", describe(saved.error()));
}

int Up::run() {
  narrator_.begin(executor_.now());
  Result<host::HostPlaces> places = host::host_places(choices_, cell_, host_, directory_);
  if (!places) return complain(places.error(), exit_usage);
  places_ = std::move(*places);
  Result<std::unique_ptr<client::RemoteBoard>> ears =
      client::keyed_board(executor_, places_.board, places_.key, "narrator");
  if (!ears) return complain(ears.error(), exit_usage);
  const Result<void> started = start_all();
  if (!started) {
    supervisor_.stop();
    executor_.run_until([this] { return supervisor_.stopped(); });
    return complain(started.error(), exit_unavailable);
  }
  return run_until_stopped(**ears);
}

int Up::run_until_stopped(client::RemoteBoard& ears) {
  save_state();
  narrator_.say(executor_.now(), "board", places_.board);
  narrator_.say(executor_.now(), "logs", directory_.path());
  {
    const Job told = executor_.spawn(narrator_.follow(ears, executor_));
    const host::Processes processes = [this] { return supervisor_.processes(); };
    const Job present = executor_.spawn(host::tell_host(ears, executor_, host_.name, processes));
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

int run_up(const host::UpChoices& choices) {
  Result<forms::CellDescription> cell = forms::read_cell_file(choices.cell);
  if (!cell) return complain(cell.error(), exit_usage);
  const Result<simulation::WorldConfig> sound = launcher::world_config(*cell, choices.seed);
  if (!sound) return complain(sound.error(), exit_usage);
  if (story::needs_domain(*cell)) {
    const Result<forms::Domain> domain = story::domain_of(*cell);
    if (!domain) return complain(domain.error(), exit_usage);
  }
  Result<forms::CellHost> host = host::choose_host(*cell, choices.host);
  if (!host) return complain(host.error(), exit_usage);
  const Result<void> effective = host::check_options(choices, *cell, *host);
  if (!effective) return complain(effective.error(), exit_usage);
  Result<launcher::RunDirectory> directory = launcher::RunDirectory::make(cell->name, host->name);
  if (!directory) return complain(directory.error(), exit_unavailable);
  return Up(choices, std::move(*cell), std::move(*host), std::move(*directory)).run();
}

}  // namespace

void add_up_command(CLI::App& app, int& status) {
  auto choices = std::make_shared<host::UpChoices>();
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
  host::add_log_options(*up, *choices);
  up->add_option("--seed", choices->seed, "The seed of the simulated world")
      ->check(seed_check())
      ->capture_default_str();
  up->add_flag("--console", choices->console, "Also show the cell in a browser; the address is printed");
  up->add_flag("--json", choices->json, "Print one JSON object a line");
  up->footer(help_footer("up examples/01-blocks/cell.scm"));
  up->callback([choices, &status] { status = run_up(*choices); });
}

}  // namespace pizarra::programs
