// The words that `up` starts processes with: `agent`, one agent, and `world`, the simulated world.

#include <fmt/format.h>
#include <opencv2/core/utility.hpp>
#include <zmq.hpp>

#include "agents/launcher/agent_factory.hpp"
#include "agents/launcher/camera_loss_news.hpp"
#include "blackboard/client/keyed_board.hpp"
#include "blackboard/client/remote_board.hpp"
#include "blackboard/streams/remote_streams.hpp"
#include "blackboard/time/real_executor.hpp"
#include "blackboard/time/stop_signals.hpp"
#include "drivers/simulation/link_address.hpp"
#include "drivers/simulation/link_server.hpp"
#include "drivers/simulation/socket_link.hpp"
#include "lisp/outside_text.hpp"
#include "programs/command_line/command_line.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/command_line/key_option.hpp"

namespace pizarra::programs {

namespace {

struct ProcessChoices {
  std::string kind;
  std::string cell;
  std::string name;
  std::string host = "localhost";
  std::string board;
  std::string world;
  std::string key;
  std::string streams;
  std::uint64_t seed = 1;
};

// A board that is there answers sooner.
constexpr Duration unremarkable = 1s;
// Less than `up` waits before it kills.
constexpr Duration standing_patience = 2s;

Task<void> say_what_is_awaited(Executor& executor, const client::RemoteBoard& board, const std::string& address) {
  co_await sleep(executor, unremarkable);
  if (!board.connected())
    fmt::print(stderr, "pizarra: no board answers at {} yet: waiting for it\n", text_of_bytes(address));
}

int run_agent(const ProcessChoices& choices) {
  const Result<forms::CellDescription> cell = forms::read_cell_file(choices.cell);
  if (!cell) return complain(cell.error(), exit_usage);
  if (choices.world.empty() && launcher::needs_world(choices.kind, *cell)) {
    const Failure none{
        "no-world", fmt::format("{}'s device is simulated in this cell: --world says where", choices.kind), {}, {}};
    return complain(none, exit_usage);
  }
  RealExecutor executor;
  const StopSignals signals(executor);
  const std::string name = choices.name.empty() ? choices.kind : choices.name;
  const auto board = client::keyed_board(executor, choices.board, choices.key, name);
  if (!board) return complain(board.error(), exit_usage);
  zmq::context_t context(1);
  std::unique_ptr<simulation::Link> link = std::make_unique<simulation::NoLink>();
  if (!choices.world.empty()) link = std::make_unique<simulation::SocketLink>(executor, context, choices.world);
  const auto streams = streams::RemoteStreams::open(executor, **board, choices.streams);
  if (!streams) return complain(streams.error(), exit_unavailable);
  runtime::AgentContext agent_context{name, choices.host, executor, **board, Random(choices.seed).split(name)};
  const auto agent = launcher::build_agent(choices.kind, std::move(agent_context), *cell, *link, streams->get());
  if (!agent) return complain(agent.error(), exit_usage);
  const Job waiting = executor.spawn(say_what_is_awaited(executor, **board, choices.board));
  Job camera;
  if (launcher::kind_of_agent(choices.kind) == "vision")
    camera = executor.spawn(launcher::log_camera_losses(**board, name, stderr));
  const Job job = executor.spawn((*agent)->run());
  executor.run_until([&job] { return job.done(); });
  if (signals.received()) {
    bool too_long = false;
    executor.call_at(executor.now() + standing_patience, [&too_long] { too_long = true; });
    const Job standing = executor.spawn((*agent)->stand_still());
    executor.run_until([&] { return standing.done() || too_long; });
    return exit_reached;
  }
  const Result<void>* ended = (*agent)->ended();
  if (ended == nullptr || *ended) return exit_failed;
  // Started again on that board it would be refused again.
  const bool hopeless = ended->error().symbol == "wrong-shape";
  return complain(ended->error(), hopeless ? exit_usage : exit_failed);
}

int run_world(const ProcessChoices& choices) {
  const Result<forms::CellDescription> cell = forms::read_cell_file(choices.cell);
  if (!cell) return complain(cell.error(), exit_usage);
  if (!simulation::is_link_address(choices.world)) {
    const Failure open{"bad-address", "the world listens at ipc://PATH alone, not at " + choices.world, {}, {}};
    return complain(open, exit_usage);
  }
  const Result<simulation::WorldConfig> config = launcher::world_config(*cell, choices.seed);
  if (!config) return complain(config.error(), exit_usage);
  RealExecutor executor;
  const StopSignals signals(executor);
  zmq::context_t context(1);
  simulation::World world(executor, *config);
  const auto server = simulation::LinkServer::listen(executor, context, choices.world, world);
  if (!server) return complain(server.error(), exit_unavailable);
  fmt::print("the world of {} is reached at {}\n", cell->name, text_of_bytes(choices.world));
  std::fflush(stdout);
  executor.run_until([] { return false; });
  return exit_reached;
}

void add_agent_command(CLI::App& app, int& status) {
  auto choices = std::make_shared<ProcessChoices>();
  CLI::App* agent = app.add_subcommand("agent", "Run one agent in this process, on a board of another.");
  agent
      ->add_option(
          "KIND", choices->kind,
          "robot, vision, pan-tilt, planner, coordinator or person; speech, slave, follower; vision-2 is another "
          "vision")
      ->required()
      ->check(launcher::kind_fault);
  agent->add_option("CELL", choices->cell, "The cell file")->required()->check(CLI::ExistingFile);
  agent->add_option("--board", choices->board, "Where the board listens: ipc:// or tcp://")->required();
  agent->add_option("--world", choices->world, "Where the simulated world listens, if its device is there: ipc://");
  add_key_option(agent, choices->key);
  agent->add_option("--streams", choices->streams,
                    "Where other machines take its image streams: tcp://HOST:PORT, or * for any port; this machine's "
                    "own take them in any case");
  agent->add_option("--name", choices->name, "Its name on the board; default: its kind");
  agent->add_option("--host", choices->host, "The host that it names in its presence")->capture_default_str();
  agent->add_option("--seed", choices->seed, "The seed of its chance")->check(seed_check())->capture_default_str();
  agent->footer(help_footer("agent planner examples/01-blocks/cell.scm --board ipc:///tmp/b --world ipc:///tmp/w"));
  agent->callback([choices, &status] { status = run_agent(*choices); });
}

void add_world_command(CLI::App& app, int& status) {
  auto choices = std::make_shared<ProcessChoices>();
  CLI::App* world = app.add_subcommand("world", "Run a cell's simulated world in this process.");
  world->add_option("CELL", choices->cell, "The cell file")->required()->check(CLI::ExistingFile);
  world->add_option("--listen", choices->world, "Where it is reached: ipc://PATH")->required();
  world->add_option("--seed", choices->seed, "The seed of its chance")->check(seed_check())->capture_default_str();
  world->footer(help_footer("world examples/01-blocks/cell.scm --listen ipc:///tmp/w"));
  world->callback([choices, &status] { status = run_world(*choices); });
}

}  // namespace
}  // namespace pizarra::programs

int main(int argc, char** argv) {
  using namespace pizarra::programs;
  // One thread: two runs of the same seed must not differ.
  cv::setNumThreads(1);
  CLI::App app("One agent of a cell, or its simulated world.", "pizarra");
  app.require_subcommand(1);
  app.set_version_flag("--version", version());
  app.footer(exit_code_help);
  int status = exit_reached;
  add_agent_command(app, status);
  add_world_command(app, status);
  return run_program(app, argc, argv, status);
}
