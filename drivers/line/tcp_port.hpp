#pragma once

// The device's side of a TCP connection: open() waits for somebody to connect. One client at a time; the next waits
// until the one before has gone.
//
//   Result<std::unique_ptr<TcpPort>> port = TcpPort::listen(executor, "127.0.0.1", 4000);    // 0: any free port

#include <memory>
#include <sys/socket.h>

#include "drivers/line/file_wire.hpp"

namespace pizarra::line {

// A socket that listens, and where.
struct Listening {
  int file;
  std::uint16_t port;
};
// For connections, or for datagrams (SOCK_DGRAM). Failure: bad-address.
Result<Listening> listen_at(const std::string& address, std::uint16_t port, int type = SOCK_STREAM);

class TcpPort : public FileWire {
 public:
  // Failure: bad-address.
  static Result<std::unique_ptr<TcpPort>> listen(Executor& executor, const std::string& address, std::uint16_t port);
  ~TcpPort() override;
  Task<Result<void>> open(Time deadline) override;
  std::uint16_t port() const { return port_; }

 private:
  TcpPort(Executor& executor, int listener, std::uint16_t port);
  int listener_;
  std::uint16_t port_;
};

}  // namespace pizarra::line
