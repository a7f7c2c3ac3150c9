#include "agents/launcher/cell_arm.hpp"

#include "drivers/arm/motoman/bsc_line.hpp"
#include "drivers/arm/motoman/ethernet_line.hpp"
#include "drivers/arm/motoman/host_link.hpp"
#include "drivers/arm/motoman/hses_link.hpp"
#include "drivers/arm/motoman/motoman_arm.hpp"
#include "drivers/arm/simple_message/motoros_arm.hpp"
#include "drivers/arm/simple_message/simple_arm.hpp"
#include "drivers/arm/universal/universal_arm.hpp"
#include "drivers/gripper/gripping_arm.hpp"
#include "drivers/gripper/modbus_gripper.hpp"
#include "drivers/line/serial_wire.hpp"
#include "drivers/line/tcp_wire.hpp"
#include "drivers/line/udp_wire.hpp"
#include "drivers/simulation/simulated_arm.hpp"

namespace pizarra::launcher {

namespace {

std::uint16_t port_of(const forms::ArmLine& line, std::size_t index) {
  return static_cast<std::uint16_t>(line.ports[index]);
}

line::ByteOrder order_of(std::string_view protocol) {
  return protocol.ends_with("big-endian") ? line::ByteOrder::big : line::ByteOrder::little;
}

arm::ArmDriver& add_hses(Parts& parts, Executor& executor, const forms::ArmLine& line, const arm::ArmModel& model) {
  auto& wire = parts.add<line::UdpWire>(executor, line.places[0], port_of(line, 0));
  auto& link = parts.add<arm::HsesLink>(executor, wire);
  return parts.add<arm::MotomanArm>(executor, link, model);
}

// A Motoman by commands in text, over whichever line carries them.
template <class Line>
arm::ArmDriver& add_host(Parts& parts, Executor& executor, line::ByteWire& wire, const arm::ArmModel& model) {
  auto& link = parts.add<arm::HostLink>(parts.add<Line>(executor, wire));
  return parts.add<arm::MotomanArm>(executor, link, model);
}

arm::ArmDriver& add_universal(Parts& parts, Executor& executor, const forms::ArmLine& line,
                              const arm::ArmModel& model) {
  auto& rtde = parts.add<line::TcpWire>(executor, line.places[0], port_of(line, 0));
  auto& script = parts.add<line::TcpWire>(executor, line.places[0], port_of(line, 1));
  auto& dashboard = parts.add<line::TcpWire>(executor, line.places[0], port_of(line, 2));
  return parts.add<arm::UniversalArm>(executor, arm::UniversalWires{rtde, script, dashboard}, model);
}

// An arm with a line for its motion and one for its state.
template <class Arm>
arm::ArmDriver& add_simple(Parts& parts, Executor& executor, const forms::ArmLine& line, const arm::ArmModel& model) {
  auto& motion = parts.add<line::TcpWire>(executor, line.places[0], port_of(line, 0));
  auto& state = parts.add<line::TcpWire>(executor, line.places[0], port_of(line, 1));
  arm::SimpleWires wires{.motion = motion, .state = state, .order = order_of(line.protocol)};
  wires.track = line.protocol.starts_with("simple-message-track");
  return parts.add<Arm>(executor, wires, model);
}

arm::ArmDriver& add_c500c(Parts& parts, Executor& executor, const forms::ArmLine& line, const arm::ArmModel& model) {
  constexpr int baud = 115200;
  constexpr double sign = -1;  // its servers count angles as the KUKA KR3 does
  auto& motion = parts.add<line::SerialWire>(executor, line.places[0], baud);
  auto& state = parts.add<line::SerialWire>(executor, line.places[1], baud);
  return parts.add<arm::SimpleArm>(executor, arm::SimpleWires{motion, state, true, line::ByteOrder::little, sign},
                                   model);
}

arm::ArmDriver& add_arm_alone(Parts& parts, Executor& executor, const forms::ArmLine& line, const arm::ArmModel& model,
                              simulation::Link& link, std::string_view simulated) {
  if (line.protocol == "hses") return add_hses(parts, executor, line, model);
  if (line.protocol == "ethernet-server") {
    auto& wire = parts.add<line::TcpWire>(executor, line.places[0], port_of(line, 0));
    return add_host<arm::EthernetLine>(parts, executor, wire, model);
  }
  if (line.protocol == "bsc") {
    auto& wire = parts.add<line::SerialWire>(executor, line.places[0], arm::BscLine::baud, line::Parity::even);
    return add_host<arm::BscLine>(parts, executor, wire, model);
  }
  if (line.protocol == "universal") return add_universal(parts, executor, line, model);
  if (line.protocol.starts_with("simple-message")) return add_simple<arm::SimpleArm>(parts, executor, line, model);
  if (line.protocol.starts_with("motoros")) return add_simple<arm::MotorosArm>(parts, executor, line, model);
  if (line.protocol == "c500c") return add_c500c(parts, executor, line, model);
  using AfterLoss = simulation::SimulatedArm::AfterLoss;
  // A plug-in's process speaks as the world's devices do.
  if (line.protocol == "plugin") return parts.add<simulation::SimulatedArm>(link, "arm", AfterLoss::fail);
  return parts.add<simulation::SimulatedArm>(link, simulated, AfterLoss::take_control);
}

}  // namespace

arm::ArmDriver& add_cell_arm(Parts& parts, Executor& executor, const forms::ArmLine& line, const arm::ArmModel& model,
                             simulation::Link& link, std::string_view simulated) {
  arm::ArmDriver& arm = add_arm_alone(parts, executor, line, model, link, simulated);
  if (line.gripper.protocol != "modbus") return arm;
  const forms::GripperSetup& setup = line.gripper;
  auto& client = parts.add<gripper::ModbusClient>(executor, setup.place, setup.port, setup.unit);
  auto& gripper = parts.add<gripper::ModbusGripper>(executor, client, setup);
  return parts.add<gripper::GrippingArm>(executor, arm, gripper);
}

}  // namespace pizarra::launcher
