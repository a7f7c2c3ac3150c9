#pragma once

// The far end of the line to the simulated world's pan-tilt unit, over the device link: what the driver of a real unit
// opens in place of a serial line.
//
//   HeadWire wire(executor, link);
//   PtuDriver unit(executor, wire);

#include "blackboard/time/executor.hpp"
#include "drivers/line/byte_wire.hpp"
#include "drivers/simulation/link.hpp"

namespace pizarra::simulation {

class HeadWire : public line::ByteWire {
 public:
  // The link outlives it.
  HeadWire(Executor& executor, Link& link) : executor_(executor), link_(link) {}
  Task<Result<void>> open(Time deadline) override;
  void close() override { open_ = false; }
  Result<void> write(std::string_view bytes) override;
  Task<Result<std::string>> read(Time deadline) override;

 private:
  static constexpr std::size_t most_unsent = 4096;
  Task<Result<std::string>> exchange();

  Executor& executor_;
  Link& link_;
  bool open_ = false;
  std::string unsent_;
};

}  // namespace pizarra::simulation
