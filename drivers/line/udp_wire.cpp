#include "drivers/line/udp_wire.hpp"

#include <cerrno>
#include <fmt/format.h>
#include <netdb.h>
#include <sys/socket.h>
#include <unistd.h>

#include "drivers/line/file_wire.hpp"
#include "drivers/line/tcp_port.hpp"

namespace pizarra::line {

namespace {

// Looking a name up blocks; it is done away from the executor's thread.
struct Lookup {
  void run() {
    addrinfo hints{};
    hints.ai_family = AF_INET;
    hints.ai_socktype = SOCK_DGRAM;
    addrinfo* found = nullptr;
    const int error = ::getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found);
    if (error != 0) {
      trouble = ::gai_strerror(error);
      return;
    }
    address = *reinterpret_cast<const sockaddr_in*>(found->ai_addr);
    ::freeaddrinfo(found);
  }

  std::string host;
  std::uint16_t port;
  sockaddr_in address{};
  std::string trouble = {};
};

}  // namespace

void UdpSocket::adopt(int file) {
  close();
  file_ = file;
  unread_.clear();
  executor_.watch_readable(file_, [this] { take_in(); });
}

void UdpSocket::close() {
  if (file_ < 0) return;
  executor_.unwatch_readable(file_);
  ::close(std::exchange(file_, -1));
  arrived_.wake_all();
}

Result<void> UdpSocket::send(std::string_view datagram) {
  if (file_ < 0) return fail("disconnected", "the line is closed");
  const auto* to = reinterpret_cast<const sockaddr*>(&peer_);
  const ssize_t sent = ::sendto(file_, datagram.data(), datagram.size(), MSG_DONTWAIT | MSG_NOSIGNAL, to, sizeof peer_);
  // One that the system has no room for is lost, like others on their way.
  if (sent >= 0 || errno == EAGAIN || errno == ENOBUFS || errno == EINTR) return {};
  return fail("disconnected", "the network takes nothing: " + system_error());
}

void UdpSocket::take_in() {
  char datagram[longest];
  while (true) {
    sockaddr_in from{};
    socklen_t size = sizeof from;
    const ssize_t count = ::recvfrom(file_, datagram, sizeof datagram, 0, reinterpret_cast<sockaddr*>(&from), &size);
    if (count < 0) break;
    if (unread_.size() < most_unread) unread_.push_back({from, std::string(datagram, static_cast<std::size_t>(count))});
  }
  arrived_.wake_all();
}

Task<Result<std::string>> UdpSocket::receive(Time deadline) {
  while (unread_.empty() && file_ >= 0) {
    const bool woken = co_await arrived_.wait(deadline);
    if (!woken) co_return fail("timeout", "nothing came over the line in time");
  }
  if (unread_.empty()) co_return fail("disconnected", "the line is closed");
  peer_ = unread_.front().from;
  std::string datagram = std::move(unread_.front().datagram);
  unread_.pop_front();
  co_return datagram;
}

Task<Result<void>> UdpWire::open(Time) {
  close();
  const auto lookup = std::make_shared<Lookup>(Lookup{.host = host_, .port = port_});
  std::function<void(const std::function<bool()>&)> work = [lookup](const std::function<bool()>&) { lookup->run(); };
  co_await executor_.offload(std::move(work), Duration::zero());
  if (!lookup->trouble.empty()) {
    const std::string sentence = fmt::format("{} is not found: {}", host_, lookup->trouble);
    co_return fail("disconnected", sentence, to_datum(host_));
  }
  const int file = ::socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (file < 0) co_return fail("disconnected", "no socket can be opened: " + system_error());
  // Others cannot mix in: only what comes from there is received.
  const auto* there = reinterpret_cast<const sockaddr*>(&lookup->address);
  if (::connect(file, there, sizeof lookup->address) != 0) {
    const std::string why = system_error();
    ::close(file);
    co_return fail("disconnected", fmt::format("{} is not reached: {}", host_, why), to_datum(host_));
  }
  talk_to(lookup->address);
  adopt(file);
  co_return Result<void>();
}

Result<std::unique_ptr<UdpPort>> UdpPort::listen(Executor& executor, const std::string& address, std::uint16_t port) {
  const Result<Listening> bound = listen_at(address, port, SOCK_DGRAM);
  if (!bound) return fail(bound);
  return std::unique_ptr<UdpPort>(new UdpPort(executor, bound->file, bound->port));
}

Task<Result<void>> UdpPort::open(Time) { co_return Result<void>(); }

}  // namespace pizarra::line
