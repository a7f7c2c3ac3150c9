#pragma once

// A controller that speaks simple_message over TCP, as REP I0004 has it.

#include <numbers>

#include "blackboard/time/executor.hpp"
#include "drivers/arm/arm_model.hpp"
#include "drivers/line/byte_wire.hpp"
#include "drivers/line/octets.hpp"
#include "tests/drivers/arm/plain/plain_arm.hpp"

namespace pizarra::arm {

class PlainSimple {
 public:
  explicit PlainSimple(const ArmModel& model, line::ByteOrder byte_order = line::ByteOrder::little)
      : order(byte_order), model_(model) {
    arm.at = arm.sent = model.ready;
  }
  PlainArm arm;
  void arrive() { arm.arrive(); }
  const line::ByteOrder order;

  std::string message(std::int32_t type, std::int32_t kind, std::int32_t code, const std::string& data) const {
    line::OctetWriter whole(order);
    whole.i32(static_cast<std::int32_t>(12 + data.size())).i32(type).i32(kind).i32(code).text(data);
    return whole.octets();
  }
  // The reply to a message without its length.
  std::string answer(std::string_view octets) {
    line::OctetReader read(octets, order);
    const std::int32_t type = read.i32();
    read.i32();
    read.i32();
    const std::string data(read.text(read.left()));
    if (type == 11) {
      line::OctetReader point(data, order);
      const std::int32_t sequence = point.i32();
      if (sequence == -4) {
        arm.stop();
      } else {
        for (std::size_t axis = 0; axis < model_.axes.size(); ++axis) {
          if (model_.axes[axis].role == Role::track) continue;
          arm.sent[axis] = static_cast<double>(point.f32()) * 180 / std::numbers::pi;
        }
        arm.move();
      }
    }
    return message(type, 3, 1, data);
  }
  // Its joints, and its status.
  std::string state() const {
    line::OctetWriter joints(order);
    joints.i32(0);
    std::size_t told = 0;
    for (std::size_t axis = 0; axis < model_.axes.size(); ++axis) {
      if (model_.axes[axis].role == Role::track) continue;
      joints.f32(static_cast<float>(arm.at[axis] * std::numbers::pi / 180));
      ++told;
    }
    for (; told < 10; ++told) joints.f32(0);
    line::OctetWriter status(order);
    status.i32(1).i32(0).i32(0).i32(0).i32(arm.moving ? 1 : 0).i32(2).i32(1);
    return message(10, 1, 0, joints.octets()) + message(13, 1, 0, status.octets());
  }

 private:
  const ArmModel& model_;
};

inline Task<void> serve_motion(Executor& executor, PlainSimple& controller, line::ByteWire& wire) {
  while (true) {
    const Time ever = executor.now() + 3600s;
    const Result<void> come = co_await wire.open(ever);
    std::string unread;
    while (come) {
      const Result<std::string> some = co_await wire.read(ever);
      if (!some) break;
      unread += *some;
      while (unread.size() >= 4) {
        const std::size_t length = line::OctetReader(unread, controller.order).u32();
        if (unread.size() < 4 + length) break;
        static_cast<void>(wire.write(controller.answer(std::string_view(unread).substr(4, length))));
        unread.erase(0, 4 + length);
      }
    }
  }
}

inline Task<void> serve_state(Executor& executor, PlainSimple& controller, line::ByteWire& wire) {
  while (true) {
    const Time ever = executor.now() + 3600s;
    Result<void> line = co_await wire.open(ever);
    while (line) {
      co_await sleep(executor, 25ms);
      if (!controller.arm.silent) line = wire.write(controller.state());
      const Time now = executor.now();
      const Result<std::string> hung_up = co_await wire.read(now);
      if (!hung_up && hung_up.error().symbol == "disconnected") break;
    }
  }
}

}  // namespace pizarra::arm
