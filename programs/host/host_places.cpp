#include "programs/host/host_places.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <optional>

#include "agents/launcher/agent_factory.hpp"
#include "blackboard/cluster/log_address.hpp"
#include "blackboard/server/key_folder.hpp"
#include "blackboard/wire/wire_address.hpp"
#include "lisp/outside_text.hpp"

namespace pizarra::host {

namespace {

bool runs_board(const UpChoices& choices, const forms::CellDescription& cell, const forms::CellHost& host) {
  return host.name == cell.board_host && choices.board.empty();
}

// Of those that may come to this host's board.
const std::string& key_folder(const UpChoices& choices, const forms::CellDescription& cell) {
  return choices.keys.empty() ? cell.board_keys : choices.keys;
}

// With keys the board's own host needs none: it comes over a file of its own.
HostPlaces board_and_keys(const UpChoices& choices, const forms::CellDescription& cell, const forms::CellHost& host,
                          const launcher::RunDirectory& directory) {
  HostPlaces places{.owns_board = runs_board(choices, cell, host), .board = {}, .world = {}, .keys = {}, .key = {}};
  const std::string own_address = wire::ipc_address(directory.file("board.ipc"));
  const std::string& folder = key_folder(choices, cell);
  if (places.owns_board && !cell.board_address.empty()) places.keys = folder;
  places.board = !choices.board.empty()                               ? choices.board
                 : cell.board_address.empty() || !places.keys.empty() ? own_address
                                                                      : cell.board_address;
  const std::string key = choices.key.empty() ? host.key : choices.key;
  const bool shared = !choices.log.empty();
  if (shared && !cell.board_address.empty()) places.board = cell.board_address;
  if (shared && (places.owns_board || !choices.standby.empty())) places.keys = folder;
  if ((shared || !places.owns_board) && !key.empty()) places.key = std::filesystem::absolute(key).string();
  return places;
}

// The state of the host that runs the world, where that is up on this machine.
std::optional<launcher::RunState> world_host(const forms::CellDescription& cell) {
  for (const launcher::RunState& run : launcher::running_cells()) {
    if (run.cell == cell.name && run.host == cell.board_host) return run;
  }
  return std::nullopt;
}

Result<void> check_standby(const UpChoices& choices, const forms::CellDescription& cell, bool owns_board) {
  if (choices.standby.empty()) return {};
  if (owns_board) return fail("bad-option", "--standby is for another host than that of the cell's board");
  const Result<std::vector<std::string>> addresses = wire::addresses_from(cell.board_address);
  if (addresses && std::ranges::count(*addresses, choices.standby) > 0) return {};
  return fail("bad-option",
              fmt::format("no client would look for a board at --standby {}: the cell file has {}",
                          text_of_bytes(choices.standby), addresses ? cell.board_address : "no address of a board"));
}

}  // namespace

Result<void> check_log(const UpChoices& choices, const forms::CellDescription& cell, const forms::CellHost& host) {
  const bool owns_board = runs_board(choices, cell, host);
  // Agents do not come to the log, so they need no certificates.
  const bool only_agents = !owns_board && choices.standby.empty() && choices.log_here.empty();
  const Result<cluster::LogAddress> log =
      cluster::LogAddress::from(choices.log, choices.certificates, choices.log_insecure || only_agents);
  if (!log) return fail(log);
  const bool has_board = owns_board || !choices.standby.empty();
  if (!has_board && !choices.past.empty()) {
    return fail("bad-option", fmt::format("--past is for a host with a board, and {} has none", host.name));
  }
  return check_standby(choices, cell, owns_board);
}

// A key of the environment is there for other words, too.
Result<void> check_options(const UpChoices& choices, const forms::CellDescription& cell, const forms::CellHost& host) {
  if (!choices.log.empty()) {
    const Result<void> log = check_log(choices, cell, host);
    const std::string& folder = key_folder(choices, cell);
    const bool has_board = runs_board(choices, cell, host) || !choices.standby.empty();
    if (!log || folder.empty() || !has_board) return log;
    const Result<server::KeyFolder> keys = server::KeyFolder::open(folder);
    return keys ? Result<void>() : fail(keys);
  }
  const bool owns_board = runs_board(choices, cell, host);
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

Result<HostPlaces> host_places(const UpChoices& choices, const forms::CellDescription& cell,
                               const forms::CellHost& host, const launcher::RunDirectory& directory) {
  HostPlaces places = board_and_keys(choices, cell, host, directory);
  places.world = choices.world.empty() ? wire::ipc_address(directory.file("world.ipc")) : choices.world;
  if (host.name == cell.board_host || !choices.world.empty()) return places;
  // The world runs beside the board's host.
  if (const std::optional<launcher::RunState> run = world_host(cell)) {
    places.world = run->world_address;
    return places;
  }
  for (const std::string& agent : host.agents) {
    const bool in_world = device_address(agent, cell, places, directory) == places.world;
    if (!launcher::needs_world(agent, cell) || !in_world) continue;
    return fail("no-world", fmt::format("{} needs the simulated world, and that runs on {}, which is not up on this "
                                        "machine: give {} to that host, or start that host here first",
                                        agent, cell.board_host, agent));
  }
  return places;
}

std::string device_address(const std::string& agent, const forms::CellDescription& cell, const HostPlaces& places,
                           const launcher::RunDirectory& directory) {
  const launcher::DevicePlugin plugin = launcher::plugin_of(agent, cell);
  return plugin.library.empty() ? places.world : wire::ipc_address(directory.file(plugin.device + "-plugin.ipc"));
}

std::string first_address(const std::string& addresses) { return addresses.substr(0, addresses.find(',')); }

}  // namespace pizarra::host
