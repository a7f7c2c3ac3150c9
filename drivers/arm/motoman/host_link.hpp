#pragma once

// A Motoman controller by the commands of its host control: as a MotomanLink, over whichever HostLine carries them.
//
//   TcpWire wire(executor, "192.168.0.3", ethernet_server_port);
//   EthernetLine line(executor, wire);        // or BscLine, over a serial line
//   HostLink link(line);
//   MotomanArm arm(executor, link, model);
//
// Positions are asked for as pulses (RPOSJ) and in the base frame (RPOSC 0). Moves are ordered as PMOVJ and MOVL. The
// gripper's variables are read and written as D variables (SAVEV 2, LOADV 2).
//
// How far it is proven: docs/write-a-driver.md; never with hardware. The order of the
// operands is that of public clients used with NX100 and DX200 controllers; what RALARM answers is from memory.

#include "drivers/arm/motoman/host_command.hpp"
#include "drivers/arm/motoman/motoman_link.hpp"

namespace pizarra::arm {

class HostLink : public MotomanLink {
 public:
  // The line outlives it.
  explicit HostLink(HostLine& line) : line_(line) {}
  Task<Result<void>> open(Time deadline) override { return line_.open(deadline); }
  Task<Result<MotomanStatus>> status() override;
  Task<Result<std::uint32_t>> alarm_code() override;
  Task<Result<MotomanPulses>> pulses() override;
  Task<Result<MotomanPose>> pose() override;
  Task<Result<void>> turn(MotomanSwitch which, bool on) override;
  Task<Result<void>> reset() override;
  Task<Result<void>> move_joints(MotomanPulses target, double part) override;
  Task<Result<void>> move_straight(MotomanPose target, double mm_s) override;
  Task<Result<std::int32_t>> variable(int number) override;
  Task<Result<void>> set_variable(int number, std::int32_t value) override;
  Duration longest_silence() const override { return line_.longest_silence(); }

 private:
  // At least `count` numbers. Failure: bad-reply.
  Task<Result<std::vector<double>>> ask(std::string name, std::string operands, std::size_t count);
  Task<Result<void>> order(std::string name, std::string operands, HostCommand::Kind kind = HostCommand::Kind::order);

  HostLine& line_;
};

}  // namespace pizarra::arm
