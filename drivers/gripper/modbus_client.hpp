#pragma once

// Registers of a device at Modbus TCP, by libmodbus, which blocks: it is called away from the executor's thread, one
// request after another.
//
//   ModbusClient client(executor, "192.168.0.11", 502, 9);
//   const Result<std::vector<std::uint16_t>> status = co_await client.read(2000, 3);
//   const Result<void> written = co_await client.write(1000, {0x0900, 0, 0xffff});
//
// Connects when first asked, and anew after a connection was lost. A call that is destroyed while it waits is
// cancelled: what it began ends by itself within the answer's time.
//
// Failures: disconnected (also a device whose answer has not come whole within 300 ms), bad-reply; refused, whose
// subject is the device's exception code.

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "blackboard/time/executor.hpp"
#include "blackboard/time/turns.hpp"
#include "lisp/result.hpp"

namespace pizarra::gripper {

class ModbusClient {
 public:
  static constexpr std::size_t most_registers = 100;

  ModbusClient(Executor& executor, std::string host, int port, int unit);
  ~ModbusClient();
  Task<Result<std::vector<std::uint16_t>>> read(int first, std::size_t count);
  Task<Result<void>> write(int first, std::vector<std::uint16_t> values);

 private:
  struct Connection;
  // The work's own context, and what came of it.
  struct Exchange;
  Task<Result<std::vector<std::uint16_t>>> carry_out(std::shared_ptr<Exchange> exchange);

  Executor& executor_;
  std::shared_ptr<Connection> connection_;
  Turns turns_;
};

}  // namespace pizarra::gripper
