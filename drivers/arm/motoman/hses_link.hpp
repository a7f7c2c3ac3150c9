#pragma once

// A Motoman controller (FS100, DX, YRC) by its High Speed Ethernet Server: UDP port 10040.
//
//   UdpWire wire(executor, "192.168.0.3", hses::port);
//   HsesLink link(executor, wire);
//   MotomanArm arm(executor, link, model);
//
// Questions and switches are sent again under the same request id every 10 ms, for a second; a move once. Whether a
// controller drops a request that it has had is in no source that we know, and it is not relied on: see MotomanArm.
//
// How far it is proven: with the emulator of drivers/simulation/controllers/ over UDP and over a network that loses,
// repeats and delays datagrams; never with hardware. Facts from the manual that hses_packet.hpp names.

#include "drivers/arm/motoman/hses_packet.hpp"
#include "drivers/arm/motoman/motoman_link.hpp"
#include "drivers/line/exchanges.hpp"

namespace pizarra::arm {

class HsesLink : public MotomanLink {
 public:
  // The wire outlives it.
  HsesLink(Executor& executor, line::DatagramWire& wire) : exchanges_(executor, wire, hses_reply_id) {}
  Task<Result<void>> open(Time deadline) override { return exchanges_.open(deadline); }
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

 private:
  // The data of the reply, which must be `size` octets.
  Task<Result<std::string>> ask(HsesRequest request, std::size_t size, line::Retries retries = {});
  Task<Result<void>> order(HsesRequest request, line::Retries retries = {});

  line::Exchanges exchanges_;
  std::uint8_t last_id_ = 0;
};

}  // namespace pizarra::arm
