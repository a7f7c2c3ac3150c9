#include "agents/launcher/cell_arm.hpp"

#include "drivers/arm/motoman/bsc_line.hpp"
#include "drivers/arm/motoman/ethernet_line.hpp"
#include "drivers/arm/motoman/host_link.hpp"
#include "drivers/arm/motoman/hses_link.hpp"
#include "drivers/arm/motoman/motoman_arm.hpp"
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

class SimulatedDevice : public CellArm {
 public:
  SimulatedDevice(simulation::Link& link, std::string_view device) : arm_(link, device) {}
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

class EthernetServerDevice : public CellArm {
 public:
  EthernetServerDevice(Executor& executor, const forms::ArmLine& line, const arm::ArmModel& model)
      : wire_(executor, line.places[0], port_of(line, 0)),
        line_(executor, wire_),
        link_(line_),
        arm_(executor, link_, model) {}
  arm::ArmDriver& driver() override { return arm_; }

 private:
  line::TcpWire wire_;
  arm::EthernetLine line_;
  arm::HostLink link_;
  arm::MotomanArm arm_;
};

class BscDevice : public CellArm {
 public:
  BscDevice(Executor& executor, const forms::ArmLine& line, const arm::ArmModel& model)
      : wire_(executor, line.places[0], arm::BscLine::baud, line::Parity::even),
        line_(executor, wire_),
        link_(line_),
        arm_(executor, link_, model) {}
  arm::ArmDriver& driver() override { return arm_; }

 private:
  line::SerialWire wire_;
  arm::BscLine line_;
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

class SimpleDevice : public CellArm {
 public:
  SimpleDevice(Executor& executor, const forms::ArmLine& line, const arm::ArmModel& model)
      : motion_(executor, line.places[0], port_of(line, 0)),
        state_(executor, line.places[0], port_of(line, 1)),
        arm_(executor, wires(line.protocol), model) {}
  arm::ArmDriver& driver() override { return arm_; }

 private:
  arm::SimpleWires wires(std::string_view protocol) {
    arm::SimpleWires wires{.motion = motion_, .state = state_};
    if (protocol.ends_with("big-endian")) wires.order = line::ByteOrder::big;
    wires.track = protocol.starts_with("simple-message-track");
    return wires;
  }
  line::TcpWire motion_;
  line::TcpWire state_;
  arm::SimpleArm arm_;
};

class C500cDevice : public CellArm {
 public:
  C500cDevice(Executor& executor, const forms::ArmLine& line, const arm::ArmModel& model)
      : motion_(executor, line.places[0], baud),
        state_(executor, line.places[1], baud),
        arm_(executor, {motion_, state_, true, line::ByteOrder::little, sign}, model) {}
  arm::ArmDriver& driver() override { return arm_; }

 private:
  static constexpr int baud = 115200;
  static constexpr double sign = -1;  // its servers count angles as the KUKA KR3 does
  line::SerialWire motion_;
  line::SerialWire state_;
  arm::SimpleArm arm_;
};

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
  if (line.protocol == "ethernet-server") return std::make_unique<EthernetServerDevice>(executor, line, model);
  if (line.protocol == "bsc") return std::make_unique<BscDevice>(executor, line, model);
  if (line.protocol == "universal") return std::make_unique<UniversalDevice>(executor, line, model);
  if (line.protocol.starts_with("simple-message")) return std::make_unique<SimpleDevice>(executor, line, model);
  if (line.protocol == "c500c") return std::make_unique<C500cDevice>(executor, line, model);
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
