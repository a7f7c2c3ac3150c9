#pragma once

// A serial line: 8 data bits, no parity, one stop bit, no flow control.
//
//   SerialWire wire(executor, "/dev/ttyUSB0", 9600);

#include "drivers/wire/file_wire.hpp"

namespace pizarra {

class SerialWire : public FileWire {
 public:
  // Baud rates: 9600, 19200, 38400, 57600, 115200.
  SerialWire(Executor& executor, std::string path, int baud)
      : FileWire(executor), path_(std::move(path)), baud_(baud) {}
  // Failures: disconnected; bad-baud.
  Task<Result<void>> open(Time deadline) override;

 private:
  Result<int> open_line() const;
  std::string path_;
  int baud_;
};

}  // namespace pizarra
