#pragma once

// A Motoman controller with MotoROS, as its published server takes commands and points: it follows the points in time,
// by the cubic that has place and speed of both ends, holds one of them beside that which it follows, and is busy
// meanwhile. How fast each axis was and how long it stood within a trajectory is kept for who judges the driver by it.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "drivers/arm/arm_model.hpp"
#include "tests/drivers/arm/plain/plain_lines.hpp"

namespace pizarra::arm {

class PlainMotoros {
 public:
  using Numbers = std::array<double, 10>;
  explicit PlainMotoros(const ArmModel& model, line::ByteOrder byte_order = line::ByteOrder::little)
      : order(byte_order) {
    for (std::size_t axis = 0; axis < model.axes.size(); ++axis) {
      place_rad[axis] = model.ready[axis] * std::numbers::pi / 180;
      limit_rad_s_[axis] = model.axes[axis].speed * std::numbers::pi / 180;
    }
  }
  PlainArm arm;
  const line::ByteOrder order;
  bool started = false;  // its trajectory mode
  Numbers place_rad{};
  Numbers fastest_rad_s{};     // of each axis, so far
  double longest_still_s = 0;  // in one place within a trajectory
  int points = 0;              // that it took
  int busy = 0;                // answers

  // The reply to a message without its length.
  std::string answer(std::string_view octets) {
    line::OctetReader read(octets, order);
    const std::int32_t type = read.i32();
    read.i32();
    read.i32();
    if (type == 1) return plain_message(order, 1, 3, 1, "");
    const std::int32_t group = read.i32();
    const std::int32_t sequence = read.i32();
    std::int32_t command = type;
    std::pair<std::int32_t, std::int32_t> outcome{3, 3003};
    if (type == 2001) {
      command = read.i32();
      outcome = obey(command);
    } else if (type == 14) {
      outcome = group == 0 ? take(sequence, read) : std::pair{3, 3004};
    }
    line::OctetWriter reply(order);
    reply.i32(group).i32(sequence).i32(command).i32(outcome.first).i32(outcome.second).zeros(40);
    return plain_message(order, 2002, 3, 1, reply.octets());
  }

  // Goes on by so much time.
  void step(double seconds) {
    arm.moving = to_.has_value();
    if (!to_) return;
    now_s_ += seconds;
    const double whole_s = to_->time_s - from_.time_s;
    const double part = std::min(1.0, (now_s_ - from_.time_s) / whole_s);
    double moved = 0;
    for (std::size_t i = 0; i < place_rad.size(); ++i) {
      const double p = part, h00 = 2 * p * p * p - 3 * p * p + 1, h10 = p * p * p - 2 * p * p + p;
      const double next = h00 * from_.place[i] + h10 * whole_s * from_.speed[i] + (1 - h00) * to_->place[i] +
                          (p * p * p - p * p) * whole_s * to_->speed[i];
      fastest_rad_s[i] = std::max(fastest_rad_s[i], std::abs(next - place_rad[i]) / seconds);
      moved = std::max(moved, std::abs(next - place_rad[i]));
      place_rad[i] = next;
    }
    still_s_ = moved < 1e-7 ? still_s_ + seconds : 0;
    longest_still_s = std::max(longest_still_s, still_s_);
    if (part < 1) return;
    from_ = *to_;
    now_s_ = from_.time_s;
    to_ = std::exchange(held_, std::nullopt);
  }

  std::string state() const {
    line::OctetWriter feedback(order);
    feedback.i32(0).i32(2).f32(0);
    for (const double joint : place_rad) feedback.f32(static_cast<float>(joint));
    feedback.zeros(80);
    return plain_message(order, 15, 1, 0, feedback.octets()) + plain_status(order, arm.moving || to_, started);
  }

 private:
  struct Point {
    double time_s = 0;
    Numbers place{};
    Numbers speed{};
  };
  std::pair<std::int32_t, std::int32_t> obey(std::int32_t command) {
    if (command == 200101) return started ? std::pair{0, 0} : std::pair{2, 5008};
    if (command == 200111) {
      arm.stop();
      if (!arm.deaf) {
        to_.reset();
        held_.reset();
      }
      return {0, 0};
    }
    if (command == 200121) started = true;
    if (command == 200122) started = false;
    return command == 200121 || command == 200122 ? std::pair{0, 0} : std::pair{3, 3006};
  }
  std::pair<std::int32_t, std::int32_t> take(std::int32_t sequence, line::OctetReader& read) {
    if (!started) return {5, 5008};
    if ((read.i32() & 7) != 7) return {3, 3015};
    Point point;
    point.time_s = static_cast<double>(read.f32());
    for (double& place : point.place) place = static_cast<double>(read.f32());
    for (double& speed : point.speed) speed = static_cast<double>(read.f32());
    if (read.left() != 40) return {3, 3001};
    for (std::size_t i = 0; i < point.speed.size(); ++i) {
      if (std::abs(point.speed[i]) > 1.0001 * limit_rad_s_[i]) return {3, 3013};
      if (sequence == 0 && std::abs(point.place[i] - place_rad[i]) > 5e-4) return {3, 3011};
    }
    if (sequence == 0) {
      from_ = point;
      now_s_ = point.time_s;
      next_ = 1;
      return {0, 0};
    }
    if (sequence != next_) return {3, 3005};
    if (held_) {
      ++busy;
      return {1, 0};
    }
    (to_ ? held_ : to_) = point;
    ++next_;
    ++points;
    still_s_ = 0;
    arm.move();
    return {0, 0};
  }

  Numbers limit_rad_s_{};
  Point from_;
  std::optional<Point> to_;
  std::optional<Point> held_;
  double now_s_ = 0;
  double still_s_ = 0;
  std::int32_t next_ = 0;
};

// `part` is of the speed that the points ask for.
inline Task<void> run_motoros(Executor& executor, PlainMotoros& controller, double part = 1) {
  while (true) {
    co_await sleep(executor, 4ms);
    controller.step(0.004 * part);
  }
}

}  // namespace pizarra::arm
