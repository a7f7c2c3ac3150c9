// `console`: the cell that runs here, or one in this process, in a browser.

#include <algorithm>
#include <fmt/format.h>
#include <unistd.h>

#include "agents/console/console.hpp"
#include "agents/launcher/local_cell.hpp"
#include "blackboard/client/keyed_board.hpp"
#include "blackboard/client/remote_board.hpp"
#include "blackboard/streams/remote_streams.hpp"
#include "blackboard/time/real_executor.hpp"
#include "blackboard/time/stop_signals.hpp"
#include "blackboard/wire/wire_address.hpp"
#include "drivers/arm/arm_file.hpp"
#include "drivers/camera/opencv_files.hpp"
#include "drivers/simulation/socket_link.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/command_line/key_option.hpp"
#include "programs/commands/commands.hpp"
#include "programs/commands/console_choices.hpp"
#include "programs/commands/console_instruments.hpp"
#include "programs/commands/line_pipe.hpp"
#include "programs/commands/picture_folder.hpp"

namespace pizarra::programs {

namespace {

// Each robot agent and each second arm by its name, as the cell names them.
Result<console::CellView> view_of(const forms::CellDescription& cell) {
  console::CellView view{.name = cell.name, .arms = {}, .camera = cell.camera.pose, .head = !cell.head.empty()};
  view.cube_mm = cell.cube_mm;
  for (const std::string& name : launcher::named_agents(cell)) {
    const std::string kind = launcher::kind_of_agent(name);
    if (kind != "robot" && kind != "slave") continue;
    Result<arm::ArmModel> model = arm::read_arm_file(kind == "robot" ? cell.arm_file : cell.slave->arm_file);
    if (!model) return fail(model);
    view.reaches.emplace(name, console::reach_outline(*model, cell.cube_mm / 2));
    view.arms.emplace(name, std::move(*model));
  }
  return view;
}

// Of a cell of which nothing but its name is known.
console::CellView unknown_cell(std::string name) {
  console::CellView view;
  view.name = std::move(name);
  return view;
}

// Arm and eyes are those of the simulated world, which so is what they are about.
bool is_simulated(const forms::CellDescription& cell) {
  return cell.arm_line.protocol.empty() && cell.eyes.is_simulated();
}

// The cell file of a running cell is not on its board: it is the one given, else that with which `up` began it here.
Result<std::optional<forms::CellDescription>> file_of_running(const ConsoleChoices& choices, const Destination& to) {
  const std::string& file = choices.cell_file.empty() && to.run ? to.run->cell_file : choices.cell_file;
  if (!file.empty()) {
    Result<forms::CellDescription> cell = forms::read_cell_file(file);
    if (!cell) return fail(cell);
    return std::move(*cell);
  }
  fmt::print(stderr,
             "pizarra: of this cell the console knows no file, and draws no arm: name it, as ./pizarra console "
             "CELL\n");
  return std::nullopt;
}

std::string journal_of(const ConsoleChoices& choices, const Destination& to) {
  if (!choices.journal.empty() || !to.run) return choices.journal;
  return launcher::file_of(*to.run, "board.journal");
}

void print_address(const std::string& address) {
  fmt::print("{}\n", address);
  std::fflush(stdout);
}

// The pictures of the past, where they are wanted: in the folder that is named, or in one of their own.
class KeptPictures {
 public:
  KeptPictures(Executor& executor, const ConsoleChoices& choices) {
    if (choices.pictures_mb == 0) return;
    if (choices.pictures.empty()) own_.emplace();
    const std::string& folder = own_ ? own_->path() : choices.pictures;
    opened_ = console::PictureStore::open(executor, folder, choices.pictures_mb * std::uintmax_t{1'000'000});
  }
  std::optional<Failure> failure() const { return opened_ ? std::nullopt : std::optional(opened_.error()); }
  console::PictureStore* store() const { return opened_->get(); }

 private:
  std::optional<PictureFolder> own_;
  Result<std::unique_ptr<console::PictureStore>> opened_;  // of none: none are wanted
};

void say_no_pictures(const Failure& why) {
  fmt::print(stderr, "pizarra: pictures of the past are not kept: {}\n", why.sentence);
}

void say_elsewhere(const std::string& addresses, const std::string& address) {
  if (addresses.empty()) return;
  const Result<void> said = add_line(addresses, address);
  if (!said) fmt::print(stderr, "pizarra: the address is not in {}\n", said.error().sentence);
}

// Until somebody stops the executor; every page has left the board then.
int serve(Executor& executor, console::Console::Setup setup, const ConsoleChoices& choices) {
  const std::string& addresses = choices.addresses;
  const KeptPictures pictures(executor, choices);
  if (pictures.failure()) return complain(*pictures.failure(), exit_unavailable);
  setup.pictures = pictures.store();
  setup.trouble = say_no_pictures;
  setup.name = fmt::format("console-{}", getpid());
  setup.page_folder = shipped_file("agents/console/page/built");
  setup.next_address = [addresses](const std::string& address) {
    fmt::print(stderr, "another browser: {}\n", address);
    say_elsewhere(addresses, address);
  };
  const bool viewed = setup.foxglove.has_value();
  const auto console = console::Console::open(std::move(setup));
  if (!console) return complain(console.error(), exit_unavailable);
  print_address((*console)->address());
  if (viewed) fmt::print(stderr, "for Foxglove: {}\n", (*console)->foxglove_address());
  say_elsewhere(addresses, (*console)->address());
  executor.run_until([] { return false; });
  const Job closing = executor.spawn((*console)->close());
  executor.run_until([&closing] { return closing.done(); });
  return exit_reached;
}

int console_of_own_cell(const ConsoleChoices& choices) {
  const std::string file = choices.cell_file.empty() ? shipped_file("examples/01-blocks/cell.scm") : choices.cell_file;
  const Result<forms::CellDescription> cell = forms::read_cell_file(file);
  if (!cell) return complain(cell.error(), exit_usage);
  const Result<simulation::WorldConfig> sound = launcher::world_config(*cell, choices.seed);
  if (!sound) return complain(sound.error(), exit_usage);
  const Result<console::CellView> view = view_of(*cell);
  if (!view) return complain(view.error(), exit_usage);
  RealExecutor executor;
  const StopSignals signals(executor);
  launcher::LocalCell local(executor, *cell, choices.seed);
  for (const std::string& kind : launcher::named_agents(*cell)) {
    const Result<void> started = local.start(kind);
    if (!started) return complain(started.error(), exit_usage);
  }
  const auto board = [&local](const std::string& name, const std::string&) -> Result<std::unique_ptr<Board>> {
    return local.board().view(name);
  };
  return serve(executor,
               {.executor = executor,
                .streams = local.streams(),
                .board = board,
                .cell = *view,
                .name = {},
                .page_folder = {},
                .port = choices.port,
                .foxglove = choices.viewers(),
                .truth = is_simulated(*cell) ? truth_of_world(local.link()) : nullptr,
                .instruments = console_instruments(executor)},
               choices);
}

// A board that is reached by a file of this machine asks for none there.
bool asks_for_keys(const std::string& addresses) {
  const Result<std::vector<std::string>> each = wire::addresses_from(addresses);
  return each && std::ranges::none_of(*each, wire::is_ipc);
}

Result<void> check_abroad(const std::optional<wire::ClientKeys>& keys, const std::string& addresses) {
  if (keys && asks_for_keys(addresses)) return {};
  return fail("no-keys",
              "a page of another machine does what its key may, so the board must ask for keys: name an address where "
              "it does, --board tcp://HOST:PORT, and --key");
}

int console_of_running_cell(const ConsoleChoices& choices) {
  const Result<Destination> to = destination(choices.board);
  if (!to) return complain(to.error(), exit_unavailable);
  const Result<std::optional<wire::ClientKeys>> keys = client::keys_from(to->key);
  if (!keys) return complain(keys.error(), exit_usage);
  const std::string running = to->run ? to->run->cell : std::string();
  const auto cell = file_of_running(choices, *to);
  if (!cell) return complain(cell.error(), exit_usage);
  const Result<console::CellView> view = *cell ? view_of(**cell) : unknown_cell(running);
  if (!view) return complain(view.error(), exit_usage);
  auto abroad = abroad_of(choices);
  if (!abroad) return complain(abroad.error(), exit_usage);
  const Result<void> guarded = *abroad ? check_abroad(*keys, to->address) : Result<void>();
  if (!guarded) return complain(guarded.error(), exit_usage);
  RealExecutor executor;
  const StopSignals signals(executor);
  // Where images come from is asked in a session of its own.
  const auto board = client::keyed_board(executor, to->address, to->key, fmt::format("console-{}", getpid()));
  if (!board) return complain(board.error(), exit_usage);
  const auto streams = streams::RemoteStreams::open(executor, **board);
  if (!streams) return complain(streams.error(), exit_unavailable);
  zmq::context_t device_context(1);
  std::optional<simulation::SocketLink> world;
  if (*cell && is_simulated(**cell) && to->run) world.emplace(executor, device_context, to->run->world_address);
  const auto secret_of = [&](const std::string& key) {
    return key.empty() ? to->key : choices.keys + "/" + key + ".secret";
  };
  const auto board_of_page = [&](const std::string& name, const std::string& key) -> Result<std::unique_ptr<Board>> {
    auto made = client::keyed_board(executor, to->address, secret_of(key), name);
    if (!made) return fail(made);
    return std::unique_ptr<Board>(std::move(*made));
  };
  return serve(executor,
               {.executor = executor,
                .streams = **streams,
                .board = board_of_page,
                .cell = *view,
                .name = {},
                .page_folder = {},
                .port = choices.port,
                .journal = journal_of(choices, *to),
                .abroad = *abroad,
                .foxglove = choices.viewers(),
                .truth = world ? truth_of_world(*world) : nullptr,
                .instruments = console_instruments(executor, to->address, secret_of)},
               choices);
}

int run_console(const ConsoleChoices& choices) {
  // Its images are JPEGs.
  const Result<camera::OpencvFiles> opencv = camera::opencv_files();
  if (!opencv) return complain(opencv.error(), exit_unavailable);
  const bool own = !choices.board.ask_for_running_cell() && launcher::running_cells().empty();
  if (own && !choices.listen.empty()) {
    return complain(Failure{"bad-option", "--listen is for a cell that runs, whose board asks for keys", {}, {}},
                    exit_usage);
  }
  if (own) return console_of_own_cell(choices);
  if (!choices.seed_given) return console_of_running_cell(choices);
  return complain(Failure{"bad-option", "--seed is for a cell in this process, and one runs already", {}, {}},
                  exit_usage);
}

}  // namespace

void add_console_command(CLI::App& app, int& status) {
  auto choices = std::make_shared<ConsoleChoices>();
  CLI::App* console = app.add_subcommand(
      "console",
      "The cell that runs here, or, when none does, the demo cell in this process, in a browser: prints the "
      "address to open, and serves until it is interrupted.");
  add_console_options(*console, *choices);
  console->footer(help_footer("console"));
  console->callback([choices, console, &status] {
    choices->seed_given = console->get_option("--seed")->count() > 0;
    status = run_console(*choices);
  });
}

}  // namespace pizarra::programs
