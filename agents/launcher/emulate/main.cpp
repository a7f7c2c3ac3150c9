// pizarra-emulate: a device's controller as a program, at the end of a line that drivers open like the real one's.

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "agents/launcher/command_line/command_line.hpp"
#include "agents/launcher/command_line/word_tools.hpp"
#include "blackboard/time/real_executor.hpp"
#include "blackboard/time/stop_signals.hpp"
#include "drivers/simulation/controllers/serve.hpp"
#include "drivers/wire/pty_wire.hpp"
#include "drivers/wire/tcp_port.hpp"
#include "lisp/json.hpp"

namespace pizarra {
namespace {

struct EmulateChoices {
  std::string model;
  bool pty = false;
  std::uint16_t port = 4000;
  std::string address = "127.0.0.1";
  bool json = false;
};

struct Line {
  std::unique_ptr<ByteWire> wire;
  std::string where;  // what a driver opens
};

Result<Line> make_line(Executor& executor, const EmulateChoices& choices) {
  if (choices.pty) {
    Result<std::unique_ptr<PtyWire>> line = PtyWire::make(executor);
    if (!line) return fail(line);
    std::string path = (*line)->path();
    return Line{std::move(*line), std::move(path)};
  }
  Result<std::unique_ptr<TcpPort>> port = TcpPort::listen(executor, choices.address, choices.port);
  if (!port) return fail(port);
  std::string where = fmt::format("tcp://{}:{}", choices.address, (*port)->port());
  return Line{std::move(*port), std::move(where)};
}

// What somebody beside the unit does and sees, a line each on standard input.
class Bystander {
 public:
  Bystander(Executor& executor, PtuEmulator& unit, bool json) : executor_(executor), unit_(unit), json_(json) {
    executor_.watch_readable(STDIN_FILENO, [this] { hear(); });
  }
  Bystander(const Bystander&) = delete;
  Bystander& operator=(const Bystander&) = delete;
  ~Bystander() { executor_.unwatch_readable(STDIN_FILENO); }

 private:
  static constexpr std::size_t longest_line = 4096;

  void hear() {
    char chunk[256];
    const ssize_t count = ::read(STDIN_FILENO, chunk, sizeof chunk);
    if (count <= 0) return executor_.unwatch_readable(STDIN_FILENO);
    heard_.append(chunk, static_cast<std::size_t>(count));
    for (std::size_t end = heard_.find('\n'); end != std::string::npos; end = heard_.find('\n')) {
      act(heard_.substr(0, end));
      heard_.erase(0, end + 1);
    }
    if (heard_.size() > longest_line) heard_.clear();
  }

  void act(const std::string& line) {
    if (line.empty()) return;
    if (line == "power on" || line == "power off") {
      unit_.power(line == "power on");
    } else if (line != "status") {
      const Failure unknown{
          "unknown-command", "nobody here understands '" + line + "': power on, power off, status", {}, {}};
      complain(unknown, exit_usage);
      return;
    }
    tell();
  }

  void tell() const {
    const char* moves = unit_.moving() ? "moving" : "still";
    if (json_) {
      fmt::print("{{\"power\":{},\"pan\":{:.4f},\"tilt\":{:.4f},\"state\":\"{}\"}}\n", unit_.powered(), unit_.pan_deg(),
                 unit_.tilt_deg(), moves);
    } else {
      fmt::print("power {}, pan {:.2f} tilt {:.2f} degrees, {}\n", unit_.powered() ? "on" : "off", unit_.pan_deg(),
                 unit_.tilt_deg(), moves);
    }
    std::fflush(stdout);
  }

  Executor& executor_;
  PtuEmulator& unit_;
  bool json_;
  std::string heard_;
};

int emulate(const EmulateChoices& choices) {
  RealExecutor executor;
  const StopSignals signals(executor);
  PtuEmulator unit(executor, *find_ptu_model(choices.model));
  const Result<Line> line = make_line(executor, choices);
  if (!line) return complain(line.error(), exit_unavailable);
  const Job serving = executor.spawn(serve(executor, unit, *line->wire));
  if (choices.json) {
    fmt::print("{{\"emulates\":{},\"at\":{}}}\n", json_string(choices.model), json_string(line->where));
  } else {
    fmt::print("{} at {}\n", choices.model, line->where);
  }
  std::fflush(stdout);
  const Bystander bystander(executor, unit, choices.json);
  executor.run_until([] { return false; });
  return exit_reached;
}

std::vector<std::string> model_names() {
  std::vector<std::string> names;
  for (const PtuModel& model : ptu_models()) names.emplace_back(model.name);
  return names;
}

void add_emulate_word(CLI::App& app, int& status) {
  auto choices = std::make_shared<EmulateChoices>();
  CLI::App* emulating = app.add_subcommand(
      "emulate",
      "A device's controller without the device, for drivers to be tried on: it speaks the device's own protocol,\n"
      "keeps state, moves in time, and refuses what the device refuses. Until Ctrl-C.");
  emulating->add_option("device", choices->model, "Which: a pan-tilt unit, ptu46-17.5 or ptu46-70")
      ->required()
      ->check(CLI::IsMember(model_names()));
  CLI::Option* pty = emulating->add_flag("--pty", choices->pty, "At a pseudo-terminal, opened like a serial line");
  CLI::Option* tcp = emulating->add_option("--tcp", choices->port, "At this TCP port; 0 takes any that is free")
                         ->capture_default_str();
  tcp->excludes(pty);
  emulating->add_option("--address", choices->address, "Where its TCP port listens; only this machine otherwise")
      ->capture_default_str()
      ->excludes(pty);
  emulating->add_flag("--json", choices->json, "One JSON object a line");
  emulating->footer(
      help_footer("emulate ptu46-17.5 --tcp 4000",
                  "What somebody beside the device does is typed, a line each: `power off`, `power on`, `status`.\n"
                  "Exit status: 0 interrupted; 2 a wrong word or option; 4 no terminal or port to be had."));
  emulating->callback([choices, &status] { status = emulate(*choices); });
}

}  // namespace
}  // namespace pizarra

int main(int argc, char** argv) {
  CLI::App app("Pizarra, a blackboard for robot cells.", "pizarra");
  app.require_subcommand(1);
  int status = pizarra::exit_reached;
  pizarra::add_emulate_word(app, status);
  return pizarra::run_program(app, argc, argv, status);
}
