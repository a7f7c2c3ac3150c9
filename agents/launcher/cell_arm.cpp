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
#include "drivers/simulation/simulated_arm.hpp"
#include "drivers/line/serial_wire.hpp"
#include "drivers/line/tcp_wire.hpp"
#include "drivers/line/udp_wire.hpp"

namespace pizarra {

namespace {

std::uint16_t port_of(const ArmLine& line, std::size_t index) { return static_cast<std::uint16_t>(line.ports[index]); }

class SimulatedDevice : public CellArm {
 public:
  SimulatedDevice(Link& link, std::string_view device) : arm_(link, device) {}
  ArmDriver& driver() override { return arm_; }

 private:
  SimulatedArm arm_;
};

class HsesDevice : public CellArm {
 public:
  HsesDevice(Executor& executor, const ArmLine& line, const ArmModel& model)
      : wire_(executor, line.places[0], port_of(line, 0)), link_(executor, wire_), arm_(executor, link_, model) {}
  ArmDriver& driver() override { return arm_; }

 private:
  UdpWire wire_;
  HsesLink link_;
  MotomanArm arm_;
};

class EthernetServerDevice : public CellArm {
 public:
  EthernetServerDevice(Executor& executor, const ArmLine& line, const ArmModel& model)
      : wire_(executor, line.places[0], port_of(line, 0)),
        line_(executor, wire_),
        link_(line_),
        arm_(executor, link_, model) {}
  ArmDriver& driver() override { return arm_; }

 private:
  TcpWire wire_;
  EthernetLine line_;
  HostLink link_;
  MotomanArm arm_;
};

class BscDevice : public CellArm {
 public:
  BscDevice(Executor& executor, const ArmLine& line, const ArmModel& model)
      : wire_(executor, line.places[0], BscLine::baud, Parity::even),
        line_(executor, wire_),
        link_(line_),
        arm_(executor, link_, model) {}
  ArmDriver& driver() override { return arm_; }

 private:
  SerialWire wire_;
  BscLine line_;
  HostLink link_;
  MotomanArm arm_;
};

class UniversalDevice : public CellArm {
 public:
  UniversalDevice(Executor& executor, const ArmLine& line, const ArmModel& model)
      : rtde_(executor, line.places[0], port_of(line, 0)),
        script_(executor, line.places[0], port_of(line, 1)),
        dashboard_(executor, line.places[0], port_of(line, 2)),
        arm_(executor, {rtde_, script_, dashboard_}, model) {}
  ArmDriver& driver() override { return arm_; }

 private:
  TcpWire rtde_;
  TcpWire script_;
  TcpWire dashboard_;
  UniversalArm arm_;
};

class SimpleDevice : public CellArm {
 public:
  SimpleDevice(Executor& executor, const ArmLine& line, const ArmModel& model)
      : motion_(executor, line.places[0], port_of(line, 0)),
        state_(executor, line.places[0], port_of(line, 1)),
        arm_(executor, {.motion = motion_, .state = state_, .track = line.protocol == "simple-message-track"}, model) {}
  ArmDriver& driver() override { return arm_; }

 private:
  TcpWire motion_;
  TcpWire state_;
  SimpleArm arm_;
};

class C500cDevice : public CellArm {
 public:
  C500cDevice(Executor& executor, const ArmLine& line, const ArmModel& model)
      : motion_(executor, line.places[0], baud),
        state_(executor, line.places[1], baud),
        arm_(executor, {motion_, state_, true, ByteOrder::little, sign}, model) {}
  ArmDriver& driver() override { return arm_; }

 private:
  static constexpr int baud = 115200;
  static constexpr double sign = -1;  // its servers count angles as the KUKA KR3 does
  SerialWire motion_;
  SerialWire state_;
  SimpleArm arm_;
};

// An arm, and a gripper with a controller of its own.
class GrippingDevice : public CellArm {
 public:
  GrippingDevice(Executor& executor, std::unique_ptr<CellArm> arm, const GripperSetup& setup)
      : arm_(std::move(arm)),
        client_(executor, setup.place, setup.port, setup.unit),
        gripper_(executor, client_, setup),
        both_(arm_->driver(), gripper_) {}
  ArmDriver& driver() override { return both_; }

 private:
  std::unique_ptr<CellArm> arm_;
  ModbusClient client_;
  ModbusGripper gripper_;
  GrippingArm both_;
};

std::unique_ptr<CellArm> make_arm_alone(Executor& executor, const ArmLine& line, const ArmModel& model, Link& link,
                                          std::string_view simulated) {
  if (line.protocol == "hses") return std::make_unique<HsesDevice>(executor, line, model);
  if (line.protocol == "ethernet-server") return std::make_unique<EthernetServerDevice>(executor, line, model);
  if (line.protocol == "bsc") return std::make_unique<BscDevice>(executor, line, model);
  if (line.protocol == "universal") return std::make_unique<UniversalDevice>(executor, line, model);
  if (line.protocol.starts_with("simple-message")) return std::make_unique<SimpleDevice>(executor, line, model);
  if (line.protocol == "c500c") return std::make_unique<C500cDevice>(executor, line, model);
  return std::make_unique<SimulatedDevice>(link, simulated);
}

}  // namespace

std::unique_ptr<CellArm> make_cell_arm(Executor& executor, const ArmLine& line, const ArmModel& model, Link& link,
                                           std::string_view simulated) {
  std::unique_ptr<CellArm> arm = make_arm_alone(executor, line, model, link, simulated);
  if (line.gripper.protocol != "modbus") return arm;
  return std::make_unique<GrippingDevice>(executor, std::move(arm), line.gripper);
}

}  // namespace pizarra
