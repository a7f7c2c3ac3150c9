#include "tests/network/cell_on_hosts.hpp"

#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <stdexcept>

#include "tests/scratch.hpp"
#include "tests/source_dir.hpp"

namespace pizarra::network {

namespace {

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

CellOnHosts::CellOnHosts() : network_("cell", hosts, Network::Wires::forwarded) {
  make_keys();
  write_cell();
}

// Each host has its own secret and the board's public key; the board has everybody's public one.
void CellOnHosts::make_keys() const {
  namespace files = std::filesystem;
  const std::string folder = network_.folder("board-pc") + "keys";
  for (const char* name : {"board", "arm-pc", "eyes-pc", "board-pc"}) {
    const programs::Said made = programs::shell(fmt::format("{} keys new {} --dir {}", PIZARRA_KEYS, name, folder));
    if (made.status != 0) throw std::runtime_error(made.text);
  }
  for (const char* host : {"arm-pc", "eyes-pc"}) {
    const std::string secret = std::string(host) + ".secret";
    files::create_directories(network_.folder(host) + "keys");
    files::rename(folder + "/" + secret, network_.folder(host) + "keys/" + secret);
    files::copy_file(folder + "/board.key", network_.folder(host) + "keys/board.key");
  }
}

void CellOnHosts::write_cell() const {
  const std::string text = fmt::format(
      "(cell three (world (cube circle (at 450 -60)) (cube triangle (at 450 60))) (domain \"{}/domains/blocks.scm\")\n"
      " (board \"board-pc\" \"tcp://{}:7943\" (keys \"keys\"))\n"
      " (host \"arm-pc\" (agents robot person) (key \"keys/arm-pc.secret\"))\n"
      " (host \"eyes-pc\" (agents vision) (key \"keys/eyes-pc.secret\"))\n"
      " (host \"board-pc\" (agents planner coordinator)))\n",
      source_dir(), network_.address("board-pc"));
  for (const std::string& host : hosts) std::ofstream(network_.folder(host) + "cell.scm") << text;
}

void CellOnHosts::up(const std::string& host) {
  const std::vector<std::string> words = {
      PIZARRA_CELL, "up", "/run/cell.scm", "--host", host, "--world", "ipc:///run/shared/world.ipc"};
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
