#pragma once

// The lines of plain controllers that speak simple_message: orders are answered over one, the state is told over the
// other. A controller has its `arm` and byte `order`, answers a message without its length, and tells its state().

#include "blackboard/time/executor.hpp"
#include "drivers/line/byte_wire.hpp"
#include "drivers/line/octets.hpp"
#include "tests/drivers/arm/plain/plain_arm.hpp"

namespace pizarra::arm {

inline std::string plain_message(line::ByteOrder order, std::int32_t type, std::int32_t kind, std::int32_t code,
                                 const std::string& data) {
  line::OctetWriter whole(order);
  whole.i32(static_cast<std::int32_t>(12 + data.size())).i32(type).i32(kind).i32(code).text(data);
  return whole.octets();
}

inline std::string plain_status(line::ByteOrder order, bool moving, bool possible) {
  line::OctetWriter status(order);
  status.i32(1).i32(0).i32(0).i32(0).i32(moving ? 1 : 0).i32(2).i32(possible ? 1 : 0);
  return plain_message(order, 13, 1, 0, status.octets());
}

template <class Controller>
Task<void> serve_motion(Executor& executor, Controller& controller, line::ByteWire& wire) {
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

template <class Controller>
Task<void> serve_state(Executor& executor, Controller& controller, line::ByteWire& wire) {
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
