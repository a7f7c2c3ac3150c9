#pragma once

// A TCP connection to a device.
//
//   TcpWire wire(executor, "192.168.0.2", 4000);

#include "drivers/line/file_wire.hpp"

namespace pizarra::line {

class TcpWire : public FileWire {
 public:
  TcpWire(Executor& executor, std::string host, std::uint16_t port)
      : FileWire(executor), host_(std::move(host)), port_(port) {}
  Task<Result<void>> open(Time deadline) override;
  std::string place() const override { return host_ + " port " + std::to_string(port_); }

 private:
  std::string host_;
  std::uint16_t port_;
};

}  // namespace pizarra::line
