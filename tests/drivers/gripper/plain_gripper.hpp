#pragma once

// A two-finger gripper as Robotiq's manual has its registers, at Modbus TCP as the protocol's document has it: a
// controller of a few lines that shares no code with the emulated one.
//
//   PlainGripper gripper;
//   const Job serving = executor.spawn(serve_gripper(executor, gripper, *port));

#include <algorithm>

#include "blackboard/time/executor.hpp"
#include "drivers/line/byte_wire.hpp"
#include "drivers/line/octets.hpp"

namespace pizarra::gripper {

class PlainGripper {
 public:
  int stops_at = 255;  // what lies between the fingers keeps them from closing further
  int writes = 0;

  // The data of a request behind its unit: function, then what it says; and the same of the answer.
  std::string answer(std::string_view request) {
    line::OctetReader read(request, line::ByteOrder::big);
    const std::uint8_t function = read.u8();
    const std::uint16_t first = read.u16();
    const std::uint16_t count = read.u16();
    line::OctetWriter answer(line::ByteOrder::big);
    answer.u8(function);
    if (function == 3 || function == 4) {
      const std::string registers = state();
      answer.u8(static_cast<std::uint8_t>(2 * count)).text(registers.substr(2u * (first - 2000u), 2u * count));
    } else if (function == 16 && first == 1000) {
      ++writes;
      read.u8();
      const std::uint8_t action = read.u8();
      read.text(2);
      obey(action, read.u8());
      answer.u16(first).u16(count);
    } else {
      return line::OctetWriter(line::ByteOrder::big).u8(function | 0x80).u8(1).octets();
    }
    return answer.octets();
  }

 private:
  void obey(int action, int position) {
    const bool activates = (action & 1) != 0;
    if (activates && !active_) looks_until_ready_ = 3;
    active_ = activates;
    goes_ = (action & 8) != 0;
    wanted_ = position;
  }
  // Registers 2000 to 2002; the fingers go on a little each time somebody looks.
  std::string state() {
    if (looks_until_ready_ > 0) --looks_until_ready_;
    const bool ready = active_ && looks_until_ready_ == 0;
    if (ready && goes_) {
      const int reach = std::min(wanted_, stops_at);
      at_ += std::clamp(reach - at_, -20, 20);
    }
    const int object = at_ == wanted_ ? 3 : at_ == stops_at && wanted_ > at_ ? 2 : 0;
    const int sta = !active_ ? 0 : ready ? 3 : 1;
    const int status = (active_ ? 1 : 0) | (goes_ ? 8 : 0) | sta << 4 | (goes_ ? object << 6 : 0);
    line::OctetWriter registers(line::ByteOrder::big);
    registers.u8(static_cast<std::uint8_t>(status)).u8(0).u8(0).u8(static_cast<std::uint8_t>(wanted_));
    return registers.u8(static_cast<std::uint8_t>(at_)).u8(7).octets();
  }
  bool active_ = false;
  bool goes_ = false;
  int looks_until_ready_ = 0;
  int wanted_ = 0;
  int at_ = 3;
};

inline Task<void> serve_gripper(Executor& executor, PlainGripper& gripper, line::ByteWire& wire) {
  while (true) {
    const Time ever = executor.now() + 3600s;
    const Result<void> come = co_await wire.open(ever);
    std::string unread;
    while (come) {
      const Result<std::string> some = co_await wire.read(ever);
      if (!some) break;
      unread += *some;
      while (unread.size() >= 7) {
        const std::size_t size = line::OctetReader(std::string_view(unread).substr(4), line::ByteOrder::big).u16();
        if (unread.size() < 6 + size) break;
        const std::string said = gripper.answer(std::string_view(unread).substr(7, size - 1));
        line::OctetWriter reply(line::ByteOrder::big);
        reply.text(unread.substr(0, 4)).u16(static_cast<std::uint16_t>(said.size() + 1)).text(unread.substr(6, 1));
        static_cast<void>(wire.write(reply.text(said).octets()));
        unread.erase(0, 6 + size);
      }
    }
  }
}

}  // namespace pizarra::gripper
