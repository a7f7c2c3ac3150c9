#pragma once

// A Motoman controller with the High Speed Ethernet Server, as its manual has the messages.

#include <cmath>
#include <deque>

#include "blackboard/time/latch.hpp"
#include "drivers/arm/arm_model.hpp"
#include "drivers/line/datagram_wire.hpp"
#include "drivers/line/octets.hpp"
#include "tests/drivers/arm/plain/plain_arm.hpp"

namespace pizarra::arm {

class PlainHses : public line::DatagramWire {
 public:
  PlainHses(Executor& executor, const ArmModel& model) : model_(model), come_(executor) {
    arm.at = arm.sent = model.ready;
  }
  PlainArm arm;
  void arrive() { arm.arrive(); }

  Task<Result<void>> open(Time) override { co_return Result<void>(); }
  void close() override {}
  Result<void> send(std::string_view datagram) override {
    line::OctetReader read(datagram, line::ByteOrder::little);
    read.text(11);
    const std::uint8_t id = read.u8();
    read.text(12);
    const std::uint16_t command = read.u16();
    const std::uint16_t instance = read.u16();
    read.u8();
    const std::uint8_t service = read.u8();
    read.u16();
    const bool asks_state = command == 0x72 || command == 0x75;
    if (arm.silent && asks_state) return {};
    const std::string data = answer(command, instance, service, read);
    line::OctetWriter reply(line::ByteOrder::little);
    reply.text("YERC").u16(0x20).u16(static_cast<std::uint16_t>(data.size())).u8(3).u8(1).u8(1).u8(id);
    reply.u32(0x8000'0000).text("99999999").u8(service | 0x80).zeros(7).text(data);
    heard_.push_back(reply.octets());
    come_.wake_all();
    return {};
  }
  Task<Result<std::string>> receive(Time deadline) override {
    while (heard_.empty()) {
      const bool woken = co_await come_.wait(deadline);
      if (!woken) co_return fail("timeout", "nothing came");
    }
    std::string datagram = std::move(heard_.front());
    heard_.pop_front();
    co_return datagram;
  }

 private:
  std::string answer(std::uint16_t command, std::uint16_t instance, std::uint8_t service, line::OctetReader& read) {
    constexpr std::uint8_t reads_one = 0x0e;
    line::OctetWriter data(line::ByteOrder::little);
    if (command == 0x72) data.u32(0x80 | (arm.moving ? 8 : 0)).u32(0x40);
    if (command == 0x75) {
      data.zeros(20);
      for (std::size_t axis = 0; axis < 8; ++axis) data.i32(axis < model_.axes.size() ? pulses(axis) : 0);
    }
    if (command == 0x83 && instance == 1 && read.u32() == 1) arm.stop();
    if (command == 0x8b) {
      read.text(16);  // robot, station, class of speed, speed
      for (std::size_t axis = 0; axis < model_.axes.size(); ++axis) {
        arm.sent[axis] = read.i32() * 360.0 / model_.axes[axis].pulses_per_turn;
      }
    }
    if (command == 0x8a || command == 0x8b) arm.move();
    if (service == reads_one) data.u32(0);
    return data.octets();
  }
  std::int32_t pulses(std::size_t axis) const {
    return static_cast<std::int32_t>(std::lround(arm.at[axis] * model_.axes[axis].pulses_per_turn / 360));
  }

  const ArmModel& model_;
  std::deque<std::string> heard_;
  WaitList come_;
};

}  // namespace pizarra::arm
