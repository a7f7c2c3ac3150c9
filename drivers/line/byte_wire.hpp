#pragma once

// A line of bytes to a device, or from the device's side to whoever drives it: serial, TCP, a pseudo-terminal.
//
// Lifecycle: open() until it succeeds; write() and read() until one fails with `disconnected`; open() again.
//
//   TcpWire wire(executor, "192.168.0.2", 4000);
//   const Result<void> open = co_await wire.open(deadline);
//   const Result<void> sent = wire.write("PP ");
//   const Result<std::string> some = co_await wire.read(deadline);   // as much as has come, a byte at least
//
// One at a time reads. Failures: timeout, disconnected.

#include <string>
#include <string_view>

#include "blackboard/time/clock.hpp"
#include "blackboard/time/task.hpp"
#include "lisp/result.hpp"

namespace pizarra::line {

class ByteWire {
 public:
  virtual ~ByteWire() = default;
  // Connects anew; what came over an earlier connection is forgotten.
  virtual Task<Result<void>> open(Time deadline) = 0;
  virtual void close() = 0;
  // All of it, at once: a line that takes no more is as good as broken.
  virtual Result<void> write(std::string_view bytes) = 0;
  virtual Task<Result<std::string>> read(Time deadline) = 0;
  // Where a person finds the device: `192.168.0.2 port 4000`, `/dev/ttyUSB0`; empty where it is no place.
  virtual std::string place() const { return {}; }
};

}  // namespace pizarra::line
