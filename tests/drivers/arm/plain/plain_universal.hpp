#pragma once

// A Universal Robots controller as its guides have the three servers: RTDE, URScript and the dashboard.

#include <charconv>
#include <numbers>

#include "blackboard/time/executor.hpp"
#include "drivers/arm/arm_model.hpp"
#include "drivers/line/byte_wire.hpp"
#include "drivers/line/octets.hpp"
#include "tests/drivers/arm/plain/plain_arm.hpp"

namespace pizarra::arm {

class PlainUniversal {
 public:
  explicit PlainUniversal(const ArmModel& model) { arm.at = arm.sent = model.ready; }
  PlainArm arm;
  std::int32_t marker = 0;
  std::string chatter = {};  // what its script server sends to whoever is connected, ten times a second

  static std::string package(char type, const std::string& payload) {
    line::OctetWriter octets(line::ByteOrder::big);
    octets.u16(static_cast<std::uint16_t>(3 + payload.size())).u8(static_cast<std::uint8_t>(type)).text(payload);
    return octets.octets();
  }
  std::string answer(char type) const {
    if (type == 'O') return package('O', "\1VECTOR6D,INT32,INT32,UINT32,INT32,INT32,DOUBLE");
    if (type == 'I') return package('I', "\1DOUBLE");
    return package(type, "\1");
  }
  std::string state() const {
    line::OctetWriter octets(line::ByteOrder::big);
    octets.u8(1);
    for (std::size_t axis = 0; axis < 6; ++axis) {
      const double deg = axis == 4 ? -90 : arm.at[axis == 5 ? 4 : axis];
      octets.f64(deg * std::numbers::pi / 180);
    }
    octets.i32(7).i32(1).u32(arm.moving ? 2 : 1).i32(marker).i32(0).f64(80);
    return package('U', octets.octets());
  }
  void run(const std::string& program) {
    if (program.find("stopj") != std::string::npos) return arm.stop();
    constexpr std::string_view begins = "write_output_integer_register(24, ";
    const std::size_t at = program.find(begins);
    if (at == std::string::npos) return;
    std::from_chars(program.data() + at + begins.size(), program.data() + program.size(), marker);
    const std::size_t joints = program.rfind("movej([");
    const char* next = joints == std::string::npos ? nullptr : program.data() + joints + 7;
    for (std::size_t axis = 0; axis < 6 && next; ++axis) {
      double rad = 0;
      next = std::from_chars(next, program.data() + program.size(), rad).ptr + 2;  // and what separates it
      if (axis != 4) arm.sent[axis == 5 ? 4 : axis] = rad * 180 / std::numbers::pi;
    }
    arm.move();
  }
  // The program has ended where it leads.
  void arrive() {
    arm.arrive();
    ++marker;
  }
  std::string dashboard(const std::string& line) {
    if (line == "get robot model") return "UR5\n";
    if (line == "PolyscopeVersion") return "URSoftware 5.11.0.108249\n";
    if (line == "is in remote control") return "true\n";
    if (line != "stop") return "done\n";
    arm.stop();
    return "Stopped\n";
  }
};

inline Task<void> serve_rtde(Executor& executor, PlainUniversal& controller, line::ByteWire& wire) {
  while (true) {
    const Time ever = executor.now() + 3600s;
    Result<void> line = co_await wire.open(ever);
    std::string unread;
    bool tells = false;
    while (line) {
      co_await sleep(executor, 8ms);
      const Time now = executor.now();
      const Result<std::string> some = co_await wire.read(now);
      if (!some && some.error().symbol == "disconnected") break;
      if (some) unread += *some;
      while (unread.size() >= 3) {
        const std::size_t size = line::OctetReader(unread, line::ByteOrder::big).u16();
        if (unread.size() < size) break;
        if (!controller.arm.silent) line = wire.write(controller.answer(unread[2]));
        tells = tells || unread[2] == 'S';
        unread.erase(0, size);
      }
      if (tells && !controller.arm.silent) line = wire.write(controller.state());
    }
  }
}

inline Task<void> serve_script(Executor& executor, PlainUniversal& controller, line::ByteWire& wire) {
  while (true) {
    const Time ever = executor.now() + 3600s;
    Result<void> line = co_await wire.open(ever);
    std::string unread;
    while (line) {
      const Time soon = executor.now() + 100ms;
      const Result<std::string> some = co_await wire.read(soon);
      if (!some && some.error().symbol == "disconnected") break;
      if (some) unread += *some;
      const std::size_t end = unread.rfind("end\n");
      if (end != std::string::npos) {
        controller.run(unread.substr(0, end));
        unread.erase(0, end + 4);
      }
      if (!controller.chatter.empty()) line = wire.write(controller.chatter);
    }
  }
}

inline Task<void> serve_dashboard(Executor& executor, PlainUniversal& controller, line::ByteWire& wire) {
  while (true) {
    const Time ever = executor.now() + 3600s;
    Result<void> line = co_await wire.open(ever);
    if (line) line = wire.write("Connected: Universal Robots Dashboard Server\n");
    std::string unread;
    while (line) {
      const Result<std::string> some = co_await wire.read(ever);
      if (!some) break;
      unread += *some;
      for (std::size_t end = unread.find('\n'); end != std::string::npos; end = unread.find('\n')) {
        line = wire.write(controller.dashboard(unread.substr(0, end)));
        unread.erase(0, end + 1);
      }
    }
  }
}

}  // namespace pizarra::arm
