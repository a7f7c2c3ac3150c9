#include "programs/emulate/arm_serving.hpp"

#include <fmt/format.h>
#include <fstream>
#include <sstream>

#include "drivers/arm/motoman/ethernet_line.hpp"
#include "drivers/line/pty_wire.hpp"
#include "drivers/line/tcp_port.hpp"
#include "drivers/line/udp_wire.hpp"
#include "drivers/simulation/controllers/arms/host_control.hpp"
#include "drivers/simulation/controllers/arms/hses_emulator.hpp"
#include "drivers/simulation/controllers/arms/motoros_emulator.hpp"
#include "drivers/simulation/controllers/arms/simple_emulator.hpp"
#include "drivers/simulation/controllers/arms/ur_emulator.hpp"

namespace pizarra::programs {

namespace {

class HsesServing : public ArmServing {
 public:
  HsesServing(Executor& executor, simulation::ArmCabinet& cabinet, std::unique_ptr<line::UdpPort> port,
              std::unique_ptr<line::UdpPort> file_port, std::string address)
      : port_(std::move(port)),
        file_port_(std::move(file_port)),
        address_(std::move(address)),
        emulator_(cabinet),
        job_(executor.spawn(serve(executor, emulator_, *port_))),
        filing_(executor.spawn(serve_files(executor, emulator_, *file_port_))) {}
  std::string where() const override {
    return fmt::format("udp://{}:{},{}", address_, port_->port(), file_port_->port());
  }

 private:
  std::unique_ptr<line::UdpPort> port_;
  std::unique_ptr<line::UdpPort> file_port_;
  std::string address_;
  simulation::HsesEmulator emulator_;
  Job job_;
  Job filing_;
};

Result<std::unique_ptr<ArmServing>> serve_hses(Executor& executor, simulation::ArmCabinet& cabinet,
                                               const EmulateChoices& choices) {
  const std::uint16_t wanted = choices.port < 0 ? arm::hses::port : static_cast<std::uint16_t>(choices.port);
  Result<std::unique_ptr<line::UdpPort>> port = line::UdpPort::listen(executor, choices.address, wanted);
  if (!port) return fail(port);
  const int after = choices.port < 0 ? simulation::HsesFiles::port : choices.port == 0 ? 0 : choices.port + 1;
  Result<std::unique_ptr<line::UdpPort>> file_port =
      line::UdpPort::listen(executor, choices.address, static_cast<std::uint16_t>(after));
  if (!file_port) return fail(file_port);
  return std::make_unique<HsesServing>(executor, cabinet, std::move(*port), std::move(*file_port), choices.address);
}

// Ports of one device: its own, any that are free (0), or those from the one asked for on.
std::vector<std::uint16_t> ports_of(const EmulateChoices& choices, std::initializer_list<std::uint16_t> own) {
  std::vector<std::uint16_t> ports(own);
  if (choices.port < 0) return ports;
  for (std::size_t i = 0; i < ports.size(); ++i) {
    ports[i] = static_cast<std::uint16_t>(choices.port == 0 ? 0 : choices.port + static_cast<int>(i));
  }
  return ports;
}

Result<std::vector<std::unique_ptr<line::TcpPort>>> listen_at_all(Executor& executor, const std::string& address,
                                                                  const std::vector<std::uint16_t>& ports) {
  std::vector<std::unique_ptr<line::TcpPort>> listening;
  for (const std::uint16_t wanted : ports) {
    Result<std::unique_ptr<line::TcpPort>> port = line::TcpPort::listen(executor, address, wanted);
    if (!port) return fail(port);
    listening.push_back(std::move(*port));
  }
  return listening;
}

std::string where_tcp(const std::string& address, const std::vector<std::unique_ptr<line::TcpPort>>& ports) {
  std::string where = fmt::format("tcp://{}:", address);
  for (std::size_t i = 0; i < ports.size(); ++i) where += fmt::format("{}{}", i == 0 ? "" : ",", ports[i]->port());
  return where;
}

class HostServing : public ArmServing {
 public:
  using Serve = Task<void> (*)(Executor&, simulation::HostControl&, line::ByteWire&);
  HostServing(Executor& executor, simulation::ArmCabinet& cabinet, Serve serve, std::unique_ptr<line::ByteWire> line,
              std::string where)
      : line_(std::move(line)),
        where_(std::move(where)),
        control_(cabinet),
        job_(executor.spawn(serve(executor, control_, *line_))) {}
  std::string where() const override { return where_; }

 private:
  std::unique_ptr<line::ByteWire> line_;
  std::string where_;
  simulation::HostControl control_;
  Job job_;
};

// The Ethernet Server, or the serial line.
Result<std::unique_ptr<ArmServing>> serve_host(Executor& executor, simulation::ArmCabinet& cabinet,
                                               const EmulateChoices& choices) {
  if (choices.pty) {
    Result<std::unique_ptr<line::PtyWire>> line = line::PtyWire::make(executor);
    if (!line) return fail(line);
    std::string where = (*line)->path();
    return std::make_unique<HostServing>(executor, cabinet, simulation::serve_bsc, std::move(*line), std::move(where));
  }
  Result<std::vector<std::unique_ptr<line::TcpPort>>> ports =
      listen_at_all(executor, choices.address, ports_of(choices, {arm::ethernet_server_port}));
  if (!ports) return fail(ports);
  std::string where = where_tcp(choices.address, *ports);
  return std::make_unique<HostServing>(executor, cabinet, simulation::serve_ethernet_server, std::move(ports->front()),
                                       std::move(where));
}

// A file of the folder; none by a name that leads elsewhere.
std::optional<std::string> stored_program(const std::string& folder, std::string_view name) {
  if (name.starts_with("/programs/")) name.remove_prefix(std::string_view("/programs/").size());
  const bool plain = !folder.empty() && !name.empty() && !name.starts_with('.') && name.find('/') == name.npos;
  if (!plain) return std::nullopt;
  std::ifstream file(folder + "/" + std::string(name));
  if (!file) return std::nullopt;
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

class UrServing : public ArmServing {
 public:
  UrServing(Executor& executor, simulation::ArmCabinet& cabinet, std::vector<std::unique_ptr<line::TcpPort>> ports,
            const EmulateChoices& choices)
      : ports_(std::move(ports)),
        address_(choices.address),
        emulator_(cabinet, [folder = choices.programs](std::string_view name) { return stored_program(folder, name); }),
        telling_(executor.spawn(simulation::serve_rtde(executor, emulator_, *ports_[0]))),
        answering_(executor.spawn(simulation::serve_dashboard(executor, emulator_, *ports_[2]))) {
    using enum simulation::UrInterface;
    for (const auto& [port, kind] : {std::pair(1, secondary), std::pair(3, primary), std::pair(4, real_time)}) {
      line::ByteWire& line = *ports_[static_cast<std::size_t>(port)];
      running_.push_back(executor.spawn(simulation::serve_interface(executor, emulator_, kind, line)));
    }
  }
  std::string where() const override { return where_tcp(address_, ports_); }

 private:
  std::vector<std::unique_ptr<line::TcpPort>> ports_;
  std::string address_;
  simulation::UrEmulator emulator_;
  Job telling_;
  Job answering_;
  std::vector<Job> running_;
};

Result<std::unique_ptr<ArmServing>> serve_ur(Executor& executor, simulation::ArmCabinet& cabinet,
                                             const EmulateChoices& choices) {
  constexpr std::uint16_t primary_port = 30001;
  constexpr std::uint16_t real_time_port = 30003;
  const std::vector<std::uint16_t> wanted = ports_of(
      choices, {arm::rtde::port, arm::rtde::script_port, arm::rtde::dashboard_port, primary_port, real_time_port});
  Result<std::vector<std::unique_ptr<line::TcpPort>>> ports = listen_at_all(executor, choices.address, wanted);
  if (!ports) return fail(ports);
  return std::make_unique<UrServing>(executor, cabinet, std::move(*ports), choices);
}

class SimpleServing : public ArmServing {
 public:
  SimpleServing(Executor& executor, simulation::ArmCabinet& cabinet, simulation::SimpleKind kind,
                std::vector<std::unique_ptr<line::ByteWire>> lines, std::string where)
      : lines_(std::move(lines)),
        where_(std::move(where)),
        emulator_(cabinet, kind),
        moving_(executor.spawn(simulation::serve_motion(executor, emulator_, *lines_[0]))),
        telling_(executor.spawn(simulation::serve_state(executor, emulator_, *lines_[1]))) {}
  std::string where() const override { return where_; }

 private:
  std::vector<std::unique_ptr<line::ByteWire>> lines_;
  std::string where_;
  simulation::SimpleEmulator emulator_;
  Job moving_;
  Job telling_;
};

// The C500C's servers count angles the other way round and move at a fifth of the arm's speed.
Result<std::unique_ptr<ArmServing>> serve_c500c(Executor& executor, simulation::ArmCabinet& cabinet) {
  Result<std::unique_ptr<line::PtyWire>> motion = line::PtyWire::make(executor);
  if (!motion) return fail(motion);
  Result<std::unique_ptr<line::PtyWire>> state = line::PtyWire::make(executor);
  if (!state) return fail(state);
  const std::string where = (*motion)->path() + "," + (*state)->path();
  std::vector<std::unique_ptr<line::ByteWire>> lines;
  lines.push_back(std::move(*motion));
  lines.push_back(std::move(*state));
  const simulation::SimpleKind kind{.serial = true, .sign = -1, .fixed_speed = 0.2};
  return std::make_unique<SimpleServing>(executor, cabinet, kind, std::move(lines), where);
}

Result<std::unique_ptr<ArmServing>> serve_simple_tcp(Executor& executor, simulation::ArmCabinet& cabinet,
                                                     const EmulateChoices& choices, simulation::SimpleKind kind) {
  const std::vector<std::uint16_t> wanted = ports_of(choices, {arm::simple::motion_port, arm::simple::state_port});
  Result<std::vector<std::unique_ptr<line::TcpPort>>> ports = listen_at_all(executor, choices.address, wanted);
  if (!ports) return fail(ports);
  const std::string where = where_tcp(choices.address, *ports);
  std::vector<std::unique_ptr<line::ByteWire>> lines;
  for (std::unique_ptr<line::TcpPort>& port : *ports) lines.push_back(std::move(port));
  return std::make_unique<SimpleServing>(executor, cabinet, kind, std::move(lines), where);
}

Result<std::unique_ptr<ArmServing>> serve_simple(Executor& executor, simulation::ArmCabinet& cabinet,
                                                 const EmulateChoices& choices) {
  return choices.pty ? serve_c500c(executor, cabinet) : serve_simple_tcp(executor, cabinet, choices, {});
}

Result<std::unique_ptr<ArmServing>> serve_with_track(Executor& executor, simulation::ArmCabinet& cabinet,
                                                     const EmulateChoices& choices) {
  return serve_simple_tcp(executor, cabinet, choices, {.track = true});
}

class MotorosServing : public ArmServing {
 public:
  MotorosServing(Executor& executor, simulation::ArmCabinet& cabinet, line::ByteOrder order,
                 std::vector<std::unique_ptr<line::TcpPort>> ports, std::string address)
      : ports_(std::move(ports)),
        address_(std::move(address)),
        emulator_(executor, cabinet, order),
        moving_(executor.spawn(simulation::serve_motion(executor, emulator_, *ports_[0]))),
        telling_(executor.spawn(simulation::serve_state(executor, emulator_, *ports_[1]))) {}
  std::string where() const override { return where_tcp(address_, ports_); }

 private:
  std::vector<std::unique_ptr<line::TcpPort>> ports_;
  std::string address_;
  simulation::MotorosEmulator emulator_;
  Job moving_;
  Job telling_;
};

template <line::ByteOrder order>
Result<std::unique_ptr<ArmServing>> serve_motoros(Executor& executor, simulation::ArmCabinet& cabinet,
                                                  const EmulateChoices& choices) {
  const std::vector<std::uint16_t> wanted = ports_of(choices, {arm::motoros::motion_port, arm::motoros::state_port});
  Result<std::vector<std::unique_ptr<line::TcpPort>>> ports = listen_at_all(executor, choices.address, wanted);
  if (!ports) return fail(ports);
  return std::make_unique<MotorosServing>(executor, cabinet, order, std::move(*ports), choices.address);
}

constexpr ArmKind kinds[] = {{"up6", "motoman-up6", serve_hses, 2},
                             {"up6-nx100", "motoman-up6", serve_host, 1, true},
                             {"up6-motoros", "motoman-up6", serve_motoros<line::ByteOrder::little>, 2},
                             {"up6-motoros-fs100", "motoman-up6", serve_motoros<line::ByteOrder::big>, 2},
                             {"ur5e", "ur5e", serve_ur, 5},
                             {"f3", "crs-f3", serve_simple, 2, true},
                             {"f3-track", "crs-f3", serve_with_track, 2}};

}  // namespace

std::span<const ArmKind> arm_kinds() { return kinds; }

}  // namespace pizarra::programs
