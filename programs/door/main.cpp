// pizarra-door: the text door of a board, for devices that say lines over TCP or a serial line (docs/small-devices.md).

#include <fmt/format.h>

#include "agents/door/door.hpp"
#include "agents/launcher/run_directory.hpp"
#include "blackboard/client/remote_board.hpp"
#include "blackboard/time/real_executor.hpp"
#include "blackboard/time/stop_signals.hpp"
#include "lisp/outside_text.hpp"
#include "programs/command_line/command_line.hpp"
#include "programs/command_line/command_tools.hpp"

namespace pizarra::programs {
namespace {

constexpr const char* usual_place = "127.0.0.1:7801";

struct DoorChoices {
  std::string board;
  std::string cell;
  std::string keys = wire::default_key_folder();
  std::string tcp;
  std::vector<std::string> serial;
};

Result<door::Door::Places> places_of(const DoorChoices& choices) {
  door::Door::Places places;
  const std::string tcp = choices.tcp.empty() && choices.serial.empty() ? usual_place : choices.tcp;
  if (!tcp.empty()) {
    Result<door::TcpPlace> place = door::tcp_place_from(tcp);
    if (!place) return fail(place);
    places.tcp = std::move(*place);
  }
  for (const std::string& text : choices.serial) {
    Result<door::SerialPlace> place = door::serial_place_from(text);
    if (!place) return fail(place);
    places.serial.push_back(std::move(*place));
  }
  return places;
}

// That of the cell that runs here, where no other is named.
Result<std::string> board_of(const DoorChoices& choices) {
  if (!choices.board.empty()) return choices.board;
  const Result<launcher::RunState> run = launcher::find_run(choices.cell);
  if (!run) return fail(run);
  return run->board_address;
}

void say_news(const std::string& news) { fmt::print(stderr, "pizarra-door: {}\n", lines_of_bytes(news)); }

int serve(const DoorChoices& choices) {
  const Result<door::Door::Places> places = places_of(choices);
  if (!places) return complain(places.error(), exit_usage);
  const Result<std::string> board = board_of(choices);
  if (!board) return complain(board.error(), exit_unavailable);
  const Result<std::vector<std::string>> readable = wire::public_key_files(choices.keys);
  if (!readable) return complain(readable.error(), exit_usage);
  RealExecutor executor;
  const StopSignals signals(executor);
  const auto connect = [&](const door::Pass& pass) -> Result<std::unique_ptr<Board>> {
    auto made =
        client::RemoteBoard::connect(executor, *board, pass.name, client::RemoteBoard::default_timeout, pass.keys);
    if (!made) return fail(made);
    return std::unique_ptr<Board>(std::move(*made));
  };
  const auto door = door::Door::open({executor, choices.keys, connect, say_news}, *places);
  if (!door) return complain(door.error(), door.error().symbol == "bad-baud" ? exit_usage : exit_unavailable);
  std::string where = places->tcp ? fmt::format(" {}:{}", places->tcp->address, (*door)->port()) : "";
  for (const door::SerialPlace& place : places->serial) where += " " + text_of_bytes(place.path);
  fmt::print("pizarra-door: ready on{}\n", where);
  std::fflush(stdout);
  executor.run_until([] { return false; });
  return exit_reached;
}

void add_door_command(CLI::App& app, int& status) {
  auto choices = std::make_shared<DoorChoices>();
  CLI::App* word = app.add_subcommand(
      "door", "The text door of a board: small devices come here, and say one form a line (docs/small-devices.md).");
  word->add_option("--tcp", choices->tcp,
                   "Where on this machine's loopback they connect, 127.0.0.1:PORT; 127.0.0.1:7801 where no serial "
                   "line is named either; port 0: any that is free")
      ->type_name("ADDRESS");
  word->add_option("--serial", choices->serial,
                   "A serial line, /dev/NAME or /dev/NAME:BAUD, at 115200 baud otherwise; may be repeated")
      ->type_name("LINE");
  word->add_option("--keys", choices->keys,
                   "The folder with the keys of the devices, made by `pizarra keys new`: a device's token is the "
                   "secret in NAME.secret, and NAME.key says what it may do")
      ->type_name("DIR")
      ->capture_default_str();
  word->add_option("--board", choices->board, "The board's address; default: the cell that runs here");
  word->add_option("--cell", choices->cell, "The running cell of this name, where several run here");
  word->footer(help_footer("door --keys keys --serial /dev/ttyUSB0:9600"));
  word->callback([choices, &status] { status = serve(*choices); });
}

}  // namespace
}  // namespace pizarra::programs

int main(int argc, char** argv) {
  CLI::App app("The text door of a board.", "pizarra");
  app.require_subcommand(1);
  app.set_version_flag("--version", pizarra::programs::version());
  app.footer(pizarra::programs::exit_code_help);
  int status = pizarra::programs::exit_reached;
  pizarra::programs::add_door_command(app, status);
  return pizarra::programs::run_program(app, argc, argv, status);
}
