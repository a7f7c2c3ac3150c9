#pragma once

// Datagrams over UDP: UdpWire to a device, UdpPort as the device. At most 64 that nobody has received are kept; more
// are lost, as anywhere on the way.
//
//   UdpWire wire(executor, "192.168.0.3", 10040);
//   Result<std::unique_ptr<UdpPort>> port = UdpPort::listen(executor, "127.0.0.1", 0);    // 0: any free port

#include <deque>
#include <memory>
#include <netinet/in.h>

#include "blackboard/time/latch.hpp"
#include "drivers/line/datagram_wire.hpp"

namespace pizarra::line {

// The part that both have in common.
class UdpSocket : public DatagramWire {
 public:
  ~UdpSocket() override { UdpSocket::close(); }
  UdpSocket(const UdpSocket&) = delete;
  UdpSocket& operator=(const UdpSocket&) = delete;
  void close() override;
  Result<void> send(std::string_view datagram) override;
  Task<Result<std::string>> receive(Time deadline) override;

 protected:
  explicit UdpSocket(Executor& executor) : executor_(executor), arrived_(executor) {}
  // Takes the file, which does not block, over.
  void adopt(int file);
  void talk_to(const sockaddr_in& peer) { peer_ = peer; }
  Executor& executor_;

 private:
  static constexpr std::size_t most_unread = 64;
  static constexpr std::size_t longest = 2048;
  struct Arrived {
    sockaddr_in from;
    std::string datagram;
  };
  void take_in();

  int file_ = -1;
  sockaddr_in peer_{};
  std::deque<Arrived> unread_;
  WaitList arrived_;
};

class UdpWire : public UdpSocket {
 public:
  UdpWire(Executor& executor, std::string host, std::uint16_t port)
      : UdpSocket(executor), host_(std::move(host)), port_(port) {}
  Task<Result<void>> open(Time deadline) override;
  std::string place() const override { return host_ + " port " + std::to_string(port_); }

 private:
  std::string host_;
  std::uint16_t port_;
};

class UdpPort : public UdpSocket {
 public:
  // Failure: bad-address.
  static Result<std::unique_ptr<UdpPort>> listen(Executor& executor, const std::string& address, std::uint16_t port);
  // Listens from the start.
  Task<Result<void>> open(Time deadline) override;
  std::uint16_t port() const { return port_; }

 private:
  UdpPort(Executor& executor, int file, std::uint16_t port) : UdpSocket(executor), port_(port) { adopt(file); }
  std::uint16_t port_;
};

}  // namespace pizarra::line
