#pragma once

// A serial line: 8 data bits, no parity or an even one, one stop bit, no flow control. A character whose parity is
// wrong comes as 0. A pseudo-terminal, which has no parity, is opened without.
//
//   SerialWire wire(executor, "/dev/ttyUSB0", 9600);

#include "drivers/line/file_wire.hpp"

namespace pizarra::line {

enum class Parity : std::uint8_t { none, even };

// Failure: bad-baud.
Result<void> check_baud(int baud);
// A file that does not block. Failures: disconnected; bad-baud.
Result<int> open_serial(const std::string& path, int baud, Parity parity);

class SerialWire : public FileWire {
 public:
  // Baud rates: 9600, 19200, 38400, 57600, 115200.
  SerialWire(Executor& executor, std::string path, int baud, Parity parity = Parity::none)
      : FileWire(executor), path_(std::move(path)), baud_(baud), parity_(parity) {}
  // Failures: disconnected; bad-baud.
  Task<Result<void>> open(Time deadline) override;
  std::string place() const override { return path_; }

 private:
  std::string path_;
  int baud_;
  Parity parity_;
};

}  // namespace pizarra::line
