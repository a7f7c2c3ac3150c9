#pragma once

// A Motoman controller that takes host control commands in text: over its Ethernet Server, or over a serial line.

#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <string>

#include "blackboard/time/executor.hpp"
#include "drivers/arm/arm_model.hpp"
#include "drivers/line/byte_wire.hpp"
#include "tests/drivers/arm/plain/plain_arm.hpp"

namespace pizarra::arm {

class PlainHost {
 public:
  explicit PlainHost(const ArmModel& model) : model_(model) { arm.at = arm.sent = model.ready; }
  PlainArm arm;
  void arrive() { arm.arrive(); }

  // None where it says nothing.
  std::optional<std::string> answer(const std::string& name, const std::string& operands) {
    const bool asks_state = name == "RSTATS" || name == "RPOSJ" || name == "RPOSC";
    if (arm.silent && asks_state) return {};
    if (name == "RSTATS") return arm.moving ? "136,64" : "128,64";
    if (name == "RPOSJ") return pulses();
    if (name == "RPOSC") return "500,0,600,180,0,0,0,0";
    if (name == "SAVEV") return "0";
    if (name == "HOLD" && operands.starts_with('1')) arm.stop();
    if (name == "PMOVJ") take(operands);
    if (name == "PMOVJ" || name == "MOVL") arm.move();
    return "0000";
  }

 private:
  std::string pulses() const {
    std::string text;
    for (std::size_t axis = 0; axis < model_.axes.size(); ++axis) {
      const long count = std::lround(arm.at[axis] * model_.axes[axis].pulses_per_turn / 360);
      text += fmt::format("{}{}", text.empty() ? "" : ",", count);
    }
    return text;
  }
  // The speed, then pulses of six axes.
  void take(std::string operands) {
    for (std::size_t axis = 0; axis < model_.axes.size(); ++axis) {
      operands.erase(0, operands.find(',') + 1);
      arm.sent[axis] = std::stol(operands) * 360.0 / model_.axes[axis].pulses_per_turn;
    }
  }
  const ArmModel& model_;
};

// Serves one who connects after another.
inline Task<void> serve_ethernet(Executor& executor, PlainHost& host, line::ByteWire& wire) {
  while (true) {
    const Time ever = executor.now() + 3600s;
    const Result<void> come = co_await wire.open(ever);
    std::string unread, command;
    while (come) {
      const Result<std::string> some = co_await wire.read(ever);
      if (!some) break;
      unread += *some;
      for (std::size_t end = unread.find('\r'); end != std::string::npos; end = unread.find('\r')) {
        const std::string line = unread.substr(0, end);
        unread.erase(0, end + 1);
        if (unread.starts_with('\n')) unread.erase(0, 1);
        std::string said;
        if (line.starts_with("CONNECT")) {
          said = "OK: NX Information Server(1.00).\r\n";
        } else if (line.starts_with("HOSTCTRL_REQUEST ")) {
          const std::string rest = line.substr(17);
          command = rest.substr(0, rest.find(' '));
          const bool without_data = rest.ends_with(" 0");
          const std::optional<std::string> answer = without_data ? host.answer(command, "") : "";
          if (answer) said = "OK: " + command + "\r\n" + (without_data ? *answer + "\r" : "");
        } else if (const std::optional<std::string> answer = host.answer(command, line)) {
          said = *answer + "\r";
        }
        static_cast<void>(wire.write(said));
      }
    }
  }
}

// The serial line: ENQ, a block, EOT, and the same back.
inline std::string bsc_block(const std::string& header, const std::string& text) {
  const std::string summed = header + '\x02' + text + "\r\x03";
  unsigned sum = 0;
  for (const char c : summed) sum += static_cast<unsigned char>(c);
  return '\x01' + summed + static_cast<char>(sum & 0xff) + static_cast<char>(sum >> 8 & 0xff);
}

inline Task<void> serve_bsc(Executor& executor, PlainHost& host, line::ByteWire& wire) {
  const Time ever = executor.now() + 3600s;
  static_cast<void>(co_await wire.open(ever));
  std::string unread;
  std::optional<std::string> answer;
  while (true) {
    const Result<std::string> some = co_await wire.read(ever);
    if (!some) {
      unread.clear();
      static_cast<void>(co_await wire.open(ever));
      continue;
    }
    unread += *some;
    bool more = true;
    while (more) {
      more = false;
      const std::size_t end = unread.find('\x03');
      if (unread.starts_with('\x05')) {
        unread.erase(0, 1);
        static_cast<void>(wire.write("\x10\x30"));
        more = true;
      } else if (unread.starts_with('\x01') && end != std::string::npos && unread.size() >= end + 3) {
        const std::string text = unread.substr(8, end - 9);
        unread.erase(0, end + 3);
        const std::size_t blank = text.find(' ');
        const std::string operands = blank == std::string::npos ? "" : text.substr(blank + 1);
        answer = host.answer(text.substr(0, blank), operands);
        static_cast<void>(wire.write("\x10\x31"));
        more = true;
      } else if (unread.starts_with('\x04')) {
        unread.erase(0, 1);
        if (answer) static_cast<void>(wire.write("\x05"));
        more = true;
      } else if (unread.starts_with("\x10\x30")) {
        unread.erase(0, 2);
        if (answer) static_cast<void>(wire.write(bsc_block(*answer == "0000" ? "90,000" : "90,001", *answer)));
        more = true;
      } else if (unread.starts_with("\x10\x31")) {
        unread.erase(0, 2);
        answer.reset();
        static_cast<void>(wire.write("\x04"));
        more = true;
      }
    }
  }
}

}  // namespace pizarra::arm
