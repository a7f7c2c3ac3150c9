#include "programs/emulate/arm_serving.hpp"

#include <fmt/format.h>
#include <fstream>
#include <sstream>
#include <type_traits>

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

// Ports of one device: its own, any that are free (0), or those from the one asked for on.
std::vector<std::uint16_t> ports_of(const EmulateChoices& choices, std::initializer_list<std::uint16_t> own) {
  std::vector<std::uint16_t> ports(own);
  if (choices.port < 0) return ports;
  for (std::size_t i = 0; i < ports.size(); ++i) {
    ports[i] = static_cast<std::uint16_t>(choices.port == 0 ? 0 : choices.port + static_cast<int>(i));
  }
  return ports;
}

// Listens at all of these; the lines are the serving's.
template <class Port>
Result<std::vector<Port*>> listen_at_all(Executor& executor, const EmulateChoices& choices,
                                         const std::vector<std::uint16_t>& ports, ArmServing& serving) {
  std::vector<Port*> listening;
  serving.where = fmt::format("{}://{}:", std::is_same_v<Port, line::UdpPort> ? "udp" : "tcp", choices.address);
  for (const std::uint16_t wanted : ports) {
    Result<std::unique_ptr<Port>> port = Port::listen(executor, choices.address, wanted);
    if (!port) return fail(port);
    serving.where += fmt::format("{}{}", listening.empty() ? "" : ",", (*port)->port());
    listening.push_back(&serving.parts.keep(std::move(*port)));
  }
  return listening;
}

Result<line::PtyWire*> open_pty(Executor& executor, ArmServing& serving) {
  Result<std::unique_ptr<line::PtyWire>> wire = line::PtyWire::make(executor);
  if (!wire) return fail(wire);
  serving.where += (serving.where.empty() ? "" : ",") + (*wire)->path();
  return &serving.parts.keep(std::move(*wire));
}

Result<ArmServing> serve_hses(Executor& executor, simulation::ArmCabinet& cabinet, const EmulateChoices& choices) {
  ArmServing serving;
  const auto ports = listen_at_all<line::UdpPort>(
      executor, choices, ports_of(choices, {arm::hses::port, simulation::HsesFiles::port}), serving);
  if (!ports) return fail(ports);
  auto& emulator = serving.parts.add<simulation::HsesEmulator>(cabinet);
  serving.parts.add<Job>(executor.spawn(serve(executor, emulator, *(*ports)[0])));
  serving.parts.add<Job>(executor.spawn(serve_files(executor, emulator, *(*ports)[1])));
  return serving;
}

// The Ethernet Server, or the serial line.
Result<ArmServing> serve_host(Executor& executor, simulation::ArmCabinet& cabinet, const EmulateChoices& choices) {
  ArmServing serving;
  if (choices.pty) {
    const Result<line::PtyWire*> wire = open_pty(executor, serving);
    if (!wire) return fail(wire);
    auto& control = serving.parts.add<simulation::HostControl>(cabinet);
    serving.parts.add<Job>(executor.spawn(simulation::serve_bsc(executor, control, **wire)));
    return serving;
  }
  const auto ports =
      listen_at_all<line::TcpPort>(executor, choices, ports_of(choices, {arm::ethernet_server_port}), serving);
  if (!ports) return fail(ports);
  auto& control = serving.parts.add<simulation::HostControl>(cabinet);
  serving.parts.add<Job>(executor.spawn(simulation::serve_ethernet_server(executor, control, *ports->front())));
  return serving;
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

Result<ArmServing> serve_ur(Executor& executor, simulation::ArmCabinet& cabinet, const EmulateChoices& choices) {
  constexpr std::uint16_t primary_port = 30001;
  constexpr std::uint16_t real_time_port = 30003;
  const std::vector<std::uint16_t> wanted = ports_of(
      choices, {arm::rtde::port, arm::rtde::script_port, arm::rtde::dashboard_port, primary_port, real_time_port});
  ArmServing serving;
  const auto ports = listen_at_all<line::TcpPort>(executor, choices, wanted, serving);
  if (!ports) return fail(ports);
  Parts& parts = serving.parts;
  auto& emulator = parts.add<simulation::UrEmulator>(
      cabinet, [folder = choices.programs](std::string_view name) { return stored_program(folder, name); });
  parts.add<Job>(executor.spawn(simulation::serve_rtde(executor, emulator, *(*ports)[0])));
  parts.add<Job>(executor.spawn(simulation::serve_dashboard(executor, emulator, *(*ports)[2])));
  using enum simulation::UrInterface;
  for (const auto& [port, kind] : {std::pair(1, secondary), std::pair(3, primary), std::pair(4, real_time)}) {
    line::ByteWire& wire = *(*ports)[static_cast<std::size_t>(port)];
    parts.add<Job>(executor.spawn(simulation::serve_interface(executor, emulator, kind, wire)));
  }
  return serving;
}

// The two lines of a controller with one for its motion and one for its state.
template <class Emulator>
void serve_both(Executor& executor, ArmServing& serving, Emulator& emulator, line::ByteWire& motion,
                line::ByteWire& state) {
  serving.parts.add<Job>(executor.spawn(simulation::serve_motion(executor, emulator, motion)));
  serving.parts.add<Job>(executor.spawn(simulation::serve_state(executor, emulator, state)));
}

// The C500C's servers count angles the other way round and move at a fifth of the arm's speed.
Result<ArmServing> serve_c500c(Executor& executor, simulation::ArmCabinet& cabinet) {
  ArmServing serving;
  const Result<line::PtyWire*> motion = open_pty(executor, serving);
  if (!motion) return fail(motion);
  const Result<line::PtyWire*> state = open_pty(executor, serving);
  if (!state) return fail(state);
  const simulation::SimpleKind kind{.serial = true, .sign = -1, .fixed_speed = 0.2};
  serve_both(executor, serving, serving.parts.add<simulation::SimpleEmulator>(cabinet, kind), **motion, **state);
  return serving;
}

Result<ArmServing> serve_simple_tcp(Executor& executor, simulation::ArmCabinet& cabinet, const EmulateChoices& choices,
                                    simulation::SimpleKind kind) {
  ArmServing serving;
  const std::vector<std::uint16_t> wanted = ports_of(choices, {arm::simple::motion_port, arm::simple::state_port});
  const auto ports = listen_at_all<line::TcpPort>(executor, choices, wanted, serving);
  if (!ports) return fail(ports);
  auto& emulator = serving.parts.add<simulation::SimpleEmulator>(cabinet, kind);
  serve_both(executor, serving, emulator, *(*ports)[0], *(*ports)[1]);
  return serving;
}

Result<ArmServing> serve_simple(Executor& executor, simulation::ArmCabinet& cabinet, const EmulateChoices& choices) {
  return choices.pty ? serve_c500c(executor, cabinet) : serve_simple_tcp(executor, cabinet, choices, {});
}

Result<ArmServing> serve_with_track(Executor& executor, simulation::ArmCabinet& cabinet,
                                    const EmulateChoices& choices) {
  return serve_simple_tcp(executor, cabinet, choices, {.track = true});
}

template <line::ByteOrder order>
Result<ArmServing> serve_motoros(Executor& executor, simulation::ArmCabinet& cabinet, const EmulateChoices& choices) {
  ArmServing serving;
  const std::vector<std::uint16_t> wanted = ports_of(choices, {arm::motoros::motion_port, arm::motoros::state_port});
  const auto ports = listen_at_all<line::TcpPort>(executor, choices, wanted, serving);
  if (!ports) return fail(ports);
  auto& emulator = serving.parts.add<simulation::MotorosEmulator>(executor, cabinet, order);
  serve_both(executor, serving, emulator, *(*ports)[0], *(*ports)[1]);
  return serving;
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
