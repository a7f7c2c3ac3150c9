#pragma once

// The line of a device that may be without power: it is then deaf and mute.
//
//   SwitchedWire line(*pty, [&] { return cabinet.powered(); });

#include <functional>

#include "drivers/line/byte_wire.hpp"

namespace pizarra::simulation {

class SwitchedWire : public line::ByteWire {
 public:
  // The wire outlives it.
  SwitchedWire(line::ByteWire& wire, std::function<bool()> powered) : wire_(wire), powered_(std::move(powered)) {}
  Task<Result<void>> open(Time deadline) override { return wire_.open(deadline); }
  void close() override { wire_.close(); }
  Result<void> write(std::string_view bytes) override { return powered_() ? wire_.write(bytes) : Result<void>(); }
  Task<Result<std::string>> read(Time deadline) override;

 private:
  line::ByteWire& wire_;
  std::function<bool()> powered_;
};

}  // namespace pizarra::simulation
