#include "programs/host/host_processes.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <iterator>

#include "agents/launcher/agent_factory.hpp"
#include "blackboard/streams/listen_address.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/host/log_member.hpp"

namespace pizarra::host {

namespace {

using Command = std::vector<std::string>;

// Pages that are many or slow make work for the console alone. Where cores are few, the board and the agents go first.
constexpr int console_niceness = 10;
// The run's folder may be one of memory.
constexpr const char* past_in_memory = "64MB";

std::string whole_path(const std::string& file) { return std::filesystem::absolute(file).string(); }

void add_key(Command& command, const std::string& key) {
  if (!key.empty()) command.insert(command.end(), {"--key", whole_path(key)});
}

class Commands {
 public:
  Commands(const UpChoices& choices, const forms::CellDescription& cell, const forms::CellHost& host,
           const HostPlaces& places, const launcher::RunDirectory& directory)
      : choices_(choices), cell_(cell), host_(host), places_(places), directory_(directory) {}

  Result<Command> log() const;
  Command shared_board() const;
  Command own_board() const;
  Command world() const;
  std::vector<HostProcess> plugins() const;
  Command door() const;
  Command agent(const std::string& name) const;

 private:
  Command scheme_agent(const forms::CellSchemeAgent& agent) const;
  std::string device(const std::string& agent) const { return device_address(agent, cell_, places_, directory_); }

  const UpChoices& choices_;
  const forms::CellDescription& cell_;
  const forms::CellHost& host_;
  const HostPlaces& places_;
  const launcher::RunDirectory& directory_;
};

// This host's part of the log; none where it has none.
Result<Command> Commands::log() const {
  if (choices_.log_here.empty()) return Command();
  const Result<cluster::LogAddress> log =
      cluster::LogAddress::from(choices_.log, choices_.certificates, choices_.log_insecure);
  if (!log) return fail(log);
  const MemberHere member{*log, choices_.log_here, choices_.log_folder};
  const Result<void> sound = check_member(member);
  const Result<void> prepared = sound ? prepare_member(member) : sound;
  if (!prepared) return fail(prepared);
  Command command = {programs::beside_this_program("pizarra-cell"),
                     "log",
                     "member",
                     choices_.log,
                     choices_.log_here,
                     whole_path(choices_.log_folder)};
  if (!choices_.certificates.empty()) {
    command.insert(command.end(), {"--log-certificates", whole_path(choices_.certificates)});
  }
  if (choices_.log_insecure) command.push_back("--log-insecure");
  return command;
}

// A board that leads or stands by; none where this host has no address for one.
Command Commands::shared_board() const {
  const std::string listens_at = places_.owns_board ? first_address(places_.board) : choices_.standby;
  if (listens_at.empty()) return {};
  Command command = {programs::beside_this_program("pizarra-board"),
                     "--listen",
                     listens_at,
                     "--log",
                     choices_.log,
                     "--name",
                     host_.name,
                     "--cell",
                     cell_.name};
  if (choices_.past.empty()) {
    command.insert(command.end(), {"--past", directory_.file("past"), "--history-size", past_in_memory});
  } else {
    command.insert(command.end(), {"--past", whole_path(choices_.past)});
  }
  if (!choices_.certificates.empty()) command.insert(command.end(), {"--log-certificates", choices_.certificates});
  if (choices_.log_insecure) command.push_back("--log-insecure");
  if (!places_.keys.empty()) command.insert(command.end(), {"--keys", places_.keys});
  return command;
}

Command Commands::own_board() const {
  if (!places_.owns_board) return {};
  Command command = {programs::beside_this_program("pizarra-board"), "--listen", places_.board, "--journal",
                     directory_.file("board.journal")};
  if (!places_.keys.empty()) command.insert(command.end(), {"--listen", cell_.board_address, "--keys", places_.keys});
  return command;
}

Command Commands::world() const {
  if (host_.name != cell_.board_host) return {};
  return {programs::beside_this_program("pizarra-agent"),
          "world",
          whole_path(choices_.cell),
          "--listen",
          places_.world,
          "--seed",
          std::to_string(choices_.seed)};
}

// Each runs where the agent of its device does.
std::vector<HostProcess> Commands::plugins() const {
  std::vector<HostProcess> out;
  for (const std::string kind : {"robot", "vision"}) {
    const launcher::DevicePlugin plugin = launcher::plugin_of(kind, cell_);
    if (plugin.library.empty() || std::ranges::count(host_.agents, kind, launcher::kind_of_agent) == 0) continue;
    out.push_back(
        {plugin.device + "-plugin",
         {programs::beside_this_program("pizarra-plugin"), plugin.device, plugin.library, "--listen", device(kind)}});
  }
  return out;
}

// Where the board asks for keys, its devices come with their own.
Command Commands::door() const {
  if (!cell_.door || host_.name != cell_.board_host) return {};
  const std::string& board = places_.keys.empty() ? places_.board : cell_.board_address;
  Command command = {
      programs::beside_this_program("pizarra-door"), "door", "--board", board, "--keys", whole_path(cell_.door->keys)};
  if (cell_.door->tcp_port) {
    command.insert(command.end(), {"--tcp", fmt::format("127.0.0.1:{}", *cell_.door->tcp_port)});
  }
  for (const forms::CellDoor::Line& line : cell_.door->lines) {
    command.insert(command.end(), {"--serial", fmt::format("{}:{}", line.file, line.baud)});
  }
  return command;
}

// An agent with a key of its own joins with it at the address that asks for keys, also on the board's own host.
Command Commands::scheme_agent(const forms::CellSchemeAgent& agent) const {
  const bool own_key = !agent.key.empty();
  const std::string& board = own_key && !places_.keys.empty() ? cell_.board_address : places_.board;
  Command command = {programs::beside_this_program("pizarra-scheme"),
                     "scheme",
                     whole_path(agent.file),
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
  add_key(command, own_key ? agent.key : places_.key);
  return command;
}

Command Commands::agent(const std::string& name) const {
  if (const forms::CellSchemeAgent* scheme = forms::scheme_agent_called(cell_, name)) return scheme_agent(*scheme);
  Command command = {programs::beside_this_program("pizarra-agent"),
                     "agent",
                     name,
                     whole_path(choices_.cell),
                     "--board",
                     places_.board,
                     "--world",
                     device(name),
                     "--host",
                     host_.name,
                     "--seed",
                     std::to_string(choices_.seed)};
  add_key(command, places_.key);
  const bool watched_elsewhere = launcher::kind_of_agent(name) == "vision" && cell_.hosts.size() > 1;
  const std::string streams =
      watched_elsewhere ? streams::stream_listen_address(first_address(cell_.board_address)) : std::string();
  if (!streams.empty()) command.insert(command.end(), {"--streams", streams});
  return command;
}

}  // namespace

Result<std::vector<HostProcess>> host_processes(const UpChoices& choices, const forms::CellDescription& cell,
                                                const forms::CellHost& host, const HostPlaces& places,
                                                const launcher::RunDirectory& directory) {
  const Commands commands(choices, cell, host, places, directory);
  Result<Command> log = commands.log();
  if (!log) return fail(log);
  std::vector<HostProcess> out = {{"log", std::move(*log)},
                                  {"board", choices.log.empty() ? commands.own_board() : commands.shared_board()},
                                  {"world", commands.world()}};
  std::ranges::move(commands.plugins(), std::back_inserter(out));
  out.push_back({"door", commands.door()});
  for (const std::string& agent : host.agents) out.push_back({agent, commands.agent(agent)});
  std::erase_if(out, [](const HostProcess& process) { return process.command.empty(); });
  return out;
}

HostProcess console_process(const UpChoices& choices, const HostPlaces& places, const std::string& addresses,
                            const std::string& pictures) {
  Command command = {programs::beside_this_program("pizarra-cell"),
                     "console",
                     whole_path(choices.cell),
                     "--board",
                     places.board,
                     "--addresses",
                     addresses,
                     "--pictures",
                     pictures};
  add_key(command, places.key);
  return {"console", std::move(command), console_niceness};
}

}  // namespace pizarra::host
