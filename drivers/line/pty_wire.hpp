#pragma once

// The device's side of a pseudo-terminal, which whoever drives it opens as if it were a serial line. As on a real one,
// the device does not notice who comes and goes.
//
//   Result<std::unique_ptr<PtyWire>> line = PtyWire::make(executor);
//   (*line)->path();        // "/dev/pts/7"

#include <memory>

#include "drivers/line/file_wire.hpp"

namespace pizarra::line {

class PtyWire : public FileWire {
 public:
  // Failure: no-terminal.
  static Result<std::unique_ptr<PtyWire>> make(Executor& executor);
  ~PtyWire() override;
  // At once; closing and opening changes nothing for the other side.
  Task<Result<void>> open(Time deadline) override;
  const std::string& path() const { return path_; }

 private:
  PtyWire(Executor& executor, int master, int slave, std::string path);
  int master_;
  int slave_;  // held open, so that the line stays when a client goes
  std::string path_;
};

}  // namespace pizarra::line
