#pragma once

// A line of datagrams to a device, or from the device's side to whoever drives it. Any of them may be lost, come twice,
// late or out of order.
//
// Lifecycle: open() until it succeeds; send() and receive(); close().
//
//   UdpWire wire(executor, "192.168.0.3", 10040);
//   const Result<void> open = co_await wire.open(deadline);
//   const Result<void> sent = wire.send(request);
//   const Result<std::string> reply = co_await wire.receive(deadline);
//
// One at a time receives. Failures: timeout, disconnected.

#include <string>
#include <string_view>

#include "blackboard/time/clock.hpp"
#include "blackboard/time/task.hpp"
#include "lisp/result.hpp"

namespace pizarra::line {

class DatagramWire {
 public:
  virtual ~DatagramWire() = default;
  virtual Task<Result<void>> open(Time deadline) = 0;
  virtual void close() = 0;
  // To the address that it was opened to; a device's port answers the newest sender.
  virtual Result<void> send(std::string_view datagram) = 0;
  virtual Task<Result<std::string>> receive(Time deadline) = 0;
  // Where a person finds the device: `192.168.0.3 port 10040`; empty where it is no place.
  virtual std::string place() const { return {}; }
};

}  // namespace pizarra::line
