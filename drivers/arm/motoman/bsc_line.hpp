#pragma once

// Host control over the serial line of older Motoman controllers (ERC, XRC, NX100), 9600 baud, even parity: a command
// goes there as one message, and the answer comes back as another.
//
//   01,000 "SVON 1" CR     ->  90,000 "0000" CR, or a code
//   01,000 "RSTATS" CR     ->  90,001 "194,64" CR
//
// A command is begun with the end of its message: what fails before is `disconnected`, what fails after `no-answer`.
// Questions and orders are then carried over once more; a motion is not. An answer takes a tenth of a second at this
// speed, and those who ask meanwhile wait for their turn; a stop waits no longer for an answer that has not begun.
//
// How far it is proven: docs/write-a-driver.md; over lines that lose, garble and invent octets, never with hardware.

#include "blackboard/time/turns.hpp"
#include "drivers/arm/held.hpp"
#include "drivers/arm/motoman/bsc_station.hpp"
#include "drivers/arm/motoman/host_command.hpp"
#include "drivers/line/device_at.hpp"

namespace pizarra::arm {

class BscLine : public HostLine {
 public:
  static constexpr int baud = 9600;

  // The wire outlives it.
  BscLine(Executor& executor, line::ByteWire& wire)
      : executor_(executor),
        device_(line::device_at("the controller", wire.place())),
        station_(executor, wire, BscStation::Manners::yields),
        turns_(executor) {}
  Task<Result<void>> open(Time deadline) override;
  Task<Result<std::string>> command(HostCommand command) override;
  // A reading takes two tenths of a second, an order as much.
  Duration longest_silence() const override { return 1s; }

 private:
  static constexpr Duration reply_time = 2s;
  static constexpr Duration look_for_stop = 50ms;
  Task<Result<std::string>> take_turn(const HostCommand& command);
  Task<Result<BscMessage>> reply();
  Task<Result<std::string>> exchange(const HostCommand& command);

  Executor& executor_;
  const std::string device_;
  BscStation station_;
  Turns turns_;
  bool stop_waits_ = false;
};

}  // namespace pizarra::arm
