#include "agents/launcher/cell_arm.hpp"

#include <array>
#include <type_traits>

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

class SimulatedDevice : public CellArm {
 public:
  SimulatedDevice(simulation::Link& link, std::string_view device,
                  simulation::SimulatedArm::AfterLoss after_loss = simulation::SimulatedArm::AfterLoss::take_control)
      : arm_(link, device, after_loss) {}
  arm::ArmDriver& driver() override { return arm_; }

 private:
  simulation::SimulatedArm arm_;
};

class HsesDevice : public CellArm {
 public:
  HsesDevice(Executor& executor, const forms::ArmLine& line, const arm::ArmModel& model)
      : wire_(executor, line.places[0], port_of(line, 0)), link_(executor, wire_), arm_(executor, link_, model) {}
  arm::ArmDriver& driver() override { return arm_; }

 private:
  line::UdpWire wire_;
  arm::HsesLink link_;
  arm::MotomanArm arm_;
};

// A Motoman by commands in text, over whichever line carries them; `where` is the wire's.
template <class Wire, class Line>
class HostDevice : public CellArm {
 public:
  template <class... Where>
  HostDevice(Executor& executor, const arm::ArmModel& model, Where... where)
      : wire_(executor, where...), line_(executor, wire_), link_(line_), arm_(executor, link_, model) {}
  arm::ArmDriver& driver() override { return arm_; }

 private:
  Wire wire_;
  Line line_;
  arm::HostLink link_;
  arm::MotomanArm arm_;
};

class UniversalDevice : public CellArm {
 public:
  UniversalDevice(Executor& executor, const forms::ArmLine& line, const arm::ArmModel& model)
      : rtde_(executor, line.places[0], port_of(line, 0)),
        script_(executor, line.places[0], port_of(line, 1)),
        dashboard_(executor, line.places[0], port_of(line, 2)),
        arm_(executor, {rtde_, script_, dashboard_}, model) {}
  arm::ArmDriver& driver() override { return arm_; }

 private:
  line::TcpWire rtde_;
  line::TcpWire script_;
  line::TcpWire dashboard_;
  arm::UniversalArm arm_;
};

// An arm with a line for its motion and one for its state; `numbers` are their ports, or what they are set to.
template <class Wire, class Driver>
class TwoLineDevice : public CellArm {
 public:
  template <class WiresOf>
  TwoLineDevice(Executor& executor, const arm::ArmModel& model, std::array<std::string, 2> places,
                std::array<int, 2> numbers, WiresOf wires_of)
      : motion_(executor, places[0], static_cast<Number>(numbers[0])),
        state_(executor, places[1], static_cast<Number>(numbers[1])),
        arm_(executor, wires_of(motion_, state_), model) {}
  arm::ArmDriver& driver() override { return arm_; }

 private:
  using Number = std::conditional_t<std::is_same_v<Wire, line::TcpWire>, std::uint16_t, int>;
  Wire motion_;
  Wire state_;
  Driver arm_;
};

std::unique_ptr<CellArm> make_simple(Executor& executor, const forms::ArmLine& line, const arm::ArmModel& model) {
  const auto wires_of = [&line](line::ByteWire& motion, line::ByteWire& state) {
    arm::SimpleWires wires{.motion = motion, .state = state, .order = order_of(line.protocol)};
    wires.track = line.protocol.starts_with("simple-message-track");
    return wires;
  };
  return std::make_unique<TwoLineDevice<line::TcpWire, arm::SimpleArm>>(
      executor, model, std::array{line.places[0], line.places[0]}, std::array{line.ports[0], line.ports[1]}, wires_of);
}

std::unique_ptr<CellArm> make_motoros(Executor& executor, const forms::ArmLine& line, const arm::ArmModel& model) {
  const auto wires_of = [&line](line::ByteWire& motion, line::ByteWire& state) {
    return arm::SimpleWires{.motion = motion, .state = state, .order = order_of(line.protocol)};
  };
  return std::make_unique<TwoLineDevice<line::TcpWire, arm::MotorosArm>>(
      executor, model, std::array{line.places[0], line.places[0]}, std::array{line.ports[0], line.ports[1]}, wires_of);
}

std::unique_ptr<CellArm> make_c500c(Executor& executor, const forms::ArmLine& line, const arm::ArmModel& model) {
  constexpr int baud = 115200;
  const auto wires_of = [](line::ByteWire& motion, line::ByteWire& state) {
    constexpr double sign = -1;  // its servers count angles as the KUKA KR3 does
    return arm::SimpleWires{motion, state, true, line::ByteOrder::little, sign};
  };
  return std::make_unique<TwoLineDevice<line::SerialWire, arm::SimpleArm>>(
      executor, model, std::array{line.places[0], line.places[1]}, std::array{baud, baud}, wires_of);
}

// An arm, and a gripper with a controller of its own.
class GrippingDevice : public CellArm {
 public:
  GrippingDevice(Executor& executor, std::unique_ptr<CellArm> arm, const forms::GripperSetup& setup)
      : arm_(std::move(arm)),
        client_(executor, setup.place, setup.port, setup.unit),
        gripper_(executor, client_, setup),
        both_(executor, arm_->driver(), gripper_) {}
  arm::ArmDriver& driver() override { return both_; }

 private:
  std::unique_ptr<CellArm> arm_;
  gripper::ModbusClient client_;
  gripper::ModbusGripper gripper_;
  gripper::GrippingArm both_;
};

std::unique_ptr<CellArm> make_arm_alone(Executor& executor, const forms::ArmLine& line, const arm::ArmModel& model,
                                        simulation::Link& link, std::string_view simulated) {
  if (line.protocol == "hses") return std::make_unique<HsesDevice>(executor, line, model);
  if (line.protocol == "ethernet-server") {
    return std::make_unique<HostDevice<line::TcpWire, arm::EthernetLine>>(executor, model, line.places[0],
                                                                          port_of(line, 0));
  }
  if (line.protocol == "bsc") {
    return std::make_unique<HostDevice<line::SerialWire, arm::BscLine>>(executor, model, line.places[0],
                                                                        arm::BscLine::baud, line::Parity::even);
  }
  if (line.protocol == "universal") return std::make_unique<UniversalDevice>(executor, line, model);
  if (line.protocol.starts_with("simple-message")) return make_simple(executor, line, model);
  if (line.protocol.starts_with("motoros")) return make_motoros(executor, line, model);
  if (line.protocol == "c500c") return make_c500c(executor, line, model);
  // A plug-in's process speaks as the world's devices do.
  if (line.protocol == "plugin") {
    return std::make_unique<SimulatedDevice>(link, "arm", simulation::SimulatedArm::AfterLoss::fail);
  }
  return std::make_unique<SimulatedDevice>(link, simulated);
}

}  // namespace

std::unique_ptr<CellArm> make_cell_arm(Executor& executor, const forms::ArmLine& line, const arm::ArmModel& model,
                                       simulation::Link& link, std::string_view simulated) {
  std::unique_ptr<CellArm> arm = make_arm_alone(executor, line, model, link, simulated);
  if (line.gripper.protocol != "modbus") return arm;
  return std::make_unique<GrippingDevice>(executor, std::move(arm), line.gripper);
}

}  // namespace pizarra::launcher
