#include "tests/network/cell_on_hosts.hpp"

#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <stdexcept>

#include "tests/network/connection.hpp"
#include "tests/scratch.hpp"
#include "tests/source_dir.hpp"

namespace pizarra::network {

namespace {

constexpr const char* world_host = "world-pc";
constexpr const char* world_address = "ipc:///run/shared/world.ipc";

std::vector<std::string> with_the_world(std::vector<std::string> hosts) {
  hosts.emplace_back(world_host);
  return hosts;
}

std::string quoted(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) {
    line += '\'';
    for (const char c : word) line += c == '\'' ? "'\\''" : std::string(1, c);
    line += "' ";
  }
  return line;
}

}  // namespace

const std::vector<std::string> CellOnHosts::hosts = {"arm-pc", "eyes-pc", "board-pc"};

CellOnHosts::CellOnHosts(Boards boards, const std::string& objects)
    : boards_(boards),
      network_("cell", boards == Boards::one ? hosts : with_the_world(hosts), Network::Wires::forwarded) {
  make_keys();
  write_cell(!objects.empty());
  if (!objects.empty()) give_objects(objects);
}

// Each host has its own secret and the board's public key; a board has everybody's public one, and its own secret.
void CellOnHosts::make_keys() const {
  namespace files = std::filesystem;
  const std::string folder = network_.folder("board-pc") + "keys";
  for (const char* name : {"board", "arm-pc", "eyes-pc", "board-pc", world_host}) {
    const programs::Said made = programs::shell(fmt::format("{} keys new {} --dir {}", PIZARRA_KEYS, name, folder));
    if (made.status != 0) throw std::runtime_error(made.text);
  }
  if (boards_ == Boards::that_take_over) {
    for (const char* host : {"arm-pc", "eyes-pc", world_host}) {
      files::copy(folder, network_.folder(host) + "keys", files::copy_options::recursive);
    }
    return;
  }
  for (const char* host : {"arm-pc", "eyes-pc"}) {
    const std::string secret = std::string(host) + ".secret";
    files::create_directories(network_.folder(host) + "keys");
    files::rename(folder + "/" + secret, network_.folder(host) + "keys/" + secret);
    files::copy_file(folder + "/board.key", network_.folder(host) + "keys/board.key");
  }
}

std::string CellOnHosts::boards() const {
  if (boards_ == Boards::one) return fmt::format("tcp://{}:{}", network_.address("board-pc"), board_port);
  std::string all;
  for (const std::string& host : hosts) {
    all += fmt::format("{}tcp://{}:{}", all.empty() ? "" : ",", network_.address(host), board_port);
  }
  return all;
}

std::string CellOnHosts::log() const {
  std::string members;
  for (const std::string& host : hosts) members += (members.empty() ? "" : ",") + network_.address(host);
  return "etcd://" + members + "/three";
}

std::string CellOnHosts::leading_host() const {
  for (const std::string& host : hosts) {
    if (listens(network_.address(host), board_port)) return host;
  }
  return "";
}

void CellOnHosts::write_cell(bool with_objects) const {
  const bool one = boards_ == Boards::one;
  const std::string text = fmt::format(
      "(cell three (world (cube circle (at 450 -60)) (cube triangle (at 450 60))) (domain "
      "\"{}/domains/blocks.scm\"){}\n"
      " (board \"{}\" \"{}\" (keys \"keys\"))\n"
      " (host \"arm-pc\" (agents robot{}) (key \"keys/arm-pc.secret\"))\n"
      " (host \"eyes-pc\" (agents vision) (key \"keys/eyes-pc.secret\"))\n"
      " (host \"board-pc\" (agents planner coordinator){}))\n",
      source_dir(), with_objects ? " (objects \"objects\")" : "", one ? "board-pc" : world_host, boards(),
      one ? " person" : "",
      one ? ""
          : " (key \"keys/board-pc.secret\"))\n (host \"world-pc\" (agents person) (key \"keys/world-pc.secret\")");
  for (const std::string& host : one ? hosts : with_the_world(hosts)) {
    std::ofstream(network_.folder(host) + "cell.scm") << text;
  }
}

// To every host: the eyes may move to another one.
void CellOnHosts::give_objects(const std::string& folder) const {
  for (const std::string& host : hosts) {
    std::filesystem::copy(folder, network_.folder(host) + "objects", std::filesystem::copy_options::recursive);
  }
}

void CellOnHosts::up(const std::string& host) {
  std::vector<std::string> words = {PIZARRA_CELL, "up", "/run/cell.scm", "--host", host, "--world", world_address};
  if (boards_ == Boards::that_take_over && host == world_host) words.insert(words.end(), {"--board", boards()});
  if (boards_ == Boards::that_take_over && host != world_host) {
    const std::string& own = network_.address(host);
    words.insert(words.end(), {"--log", log(), "--log-insecure", "--log-here", own, "--log-folder", "/run/member",
                               "--standby", fmt::format("tcp://{}:{}", own, board_port)});
  }
  running_[host] = std::make_unique<programs::Running>(network_.on(host, words), scratch_folder() + host + ".log");
}

programs::Said CellOnHosts::run(const std::string& host, const std::string& words) const {
  return programs::shell(quoted(network_.on(host, {"/bin/sh", "-c", std::string(PIZARRA_CELL) + " " + words})) +
                         "2>&1");
}

bool CellOnHosts::comes(const std::string& host, const std::string& words, const std::string& wanted,
                        std::chrono::seconds patience) const {
  return programs::wait_until([&] { return run(host, words).text.contains(wanted); }, patience);
}

bool CellOnHosts::all_are_there() const { return comes("board-pc", "ask '(person done ?what)'", "?what = "); }

std::string CellOnHosts::said() const {
  std::string all;
  for (const auto& [host, up] : running_) all += "--- " + host + "\n" + up->said();
  return all;
}

}  // namespace pizarra::network
