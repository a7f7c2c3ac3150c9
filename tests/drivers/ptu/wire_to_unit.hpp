#pragma once

// A line to an emulated unit in virtual time, whose bytes can be lost, garbled, cut and added to on their way.

#include <functional>

#include "blackboard/time/latch.hpp"
#include "drivers/line/byte_wire.hpp"
#include "drivers/simulation/controllers/ptu_emulator.hpp"
#include "tests/run_task.hpp"

namespace pizarra::ptu {

class WireToUnit : public line::ByteWire {
 public:
  WireToUnit(Executor& executor, simulation::PtuEmulator& unit) : unit_(unit), come_(executor) {
    unit_.on_say([this](std::string_view bytes) {
      if (!pulled) hear(from_unit ? from_unit(bytes) : std::string(bytes));
    });
  }

  // What becomes of bytes on their way; as they are where nothing is set.
  std::function<std::string(std::string_view)> to_unit;
  std::function<std::string(std::string_view)> from_unit;
  bool pulled = false;  // the plug
  std::string sent;     // all that was written

  void pull() {
    pulled = true;
    come_.wake_all();
  }
  void hear(std::string_view bytes) {
    heard_ += bytes;
    come_.wake_all();
  }

  Task<Result<void>> open(Time) override {
    heard_.clear();
    if (pulled) co_return fail("disconnected", "the plug is out");
    co_return Result<void>();
  }
  void close() override {}
  Result<void> write(std::string_view bytes) override {
    if (pulled) return fail("disconnected", "the plug is out");
    sent += bytes;
    unit_.receive(to_unit ? to_unit(bytes) : std::string(bytes));
    return {};
  }
  Task<Result<std::string>> read(Time deadline) override {
    while (heard_.empty() && !pulled) {
      const bool woken = co_await come_.wait(deadline);
      if (!woken) co_return fail("timeout", "nothing came");
    }
    if (heard_.empty()) co_return fail("disconnected", "the plug is out");
    co_return std::exchange(heard_, {});
  }

 private:
  simulation::PtuEmulator& unit_;
  std::string heard_;
  WaitList come_;
};

}  // namespace pizarra::ptu
