#include "agents/launcher/supervision/arm_device.hpp"

#include "drivers/arm/motoman/hses_link.hpp"
#include "drivers/arm/motoman/motoman_arm.hpp"
#include "drivers/simulation/simulated_arm.hpp"
#include "drivers/wire/udp_wire.hpp"

namespace pizarra {

namespace {

std::uint16_t port_of(const ArmLine& line, std::size_t index) { return static_cast<std::uint16_t>(line.ports[index]); }

class SimulatedDevice : public ArmDevice {
 public:
  explicit SimulatedDevice(Link& link) : arm_(link) {}
  ArmDriver& driver() override { return arm_; }

 private:
  SimulatedArm arm_;
};

class HsesDevice : public ArmDevice {
 public:
  HsesDevice(Executor& executor, const ArmLine& line, const ArmModel& model)
      : wire_(executor, line.places[0], port_of(line, 0)), link_(executor, wire_), arm_(executor, link_, model) {}
  ArmDriver& driver() override { return arm_; }

 private:
  UdpWire wire_;
  HsesLink link_;
  MotomanArm arm_;
};

}  // namespace

std::unique_ptr<ArmDevice> make_arm_device(Executor& executor, const ArmLine& line, const ArmModel& model, Link& link) {
  if (line.protocol == "hses") return std::make_unique<HsesDevice>(executor, line, model);
  return std::make_unique<SimulatedDevice>(link);
}

}  // namespace pizarra
