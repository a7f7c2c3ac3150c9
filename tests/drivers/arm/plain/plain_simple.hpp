#pragma once

// A controller that speaks simple_message over TCP, as REP I0004 has it.

#include <numbers>

#include "drivers/arm/arm_model.hpp"
#include "tests/drivers/arm/plain/plain_lines.hpp"

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
    return plain_message(order, type, 3, 1, data);
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
    return plain_message(order, 10, 1, 0, joints.octets()) + plain_status(order, arm.moving, true);
  }

 private:
  const ArmModel& model_;
};

}  // namespace pizarra::arm
