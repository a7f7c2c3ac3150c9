#include "drivers/line/tcp_wire.hpp"

#include <cerrno>
#include <fcntl.h>
#include <fmt/format.h>
#include <netdb.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace pizarra::line {

namespace {

constexpr int poll_ms = 20;

// Looking a name up and connecting block; they are done away from the executor's thread.
struct Attempt {
  Attempt(std::string the_host, std::uint16_t the_port) : host(std::move(the_host)), port(the_port) {}
  Attempt(const Attempt&) = delete;
  Attempt& operator=(const Attempt&) = delete;
  ~Attempt() {
    if (file >= 0) ::close(file);
  }
  void run(const std::function<bool()>& cancelled, Duration patience);
  bool connect_to(const addrinfo& address, const std::function<bool()>& cancelled, Duration& patience);

  std::string host;
  std::uint16_t port;
  int file = -1;
  std::string trouble;
};

bool Attempt::connect_to(const addrinfo& address, const std::function<bool()>& cancelled, Duration& patience) {
  file = ::socket(address.ai_family, address.ai_socktype | SOCK_NONBLOCK | SOCK_CLOEXEC, address.ai_protocol);
  int error = file < 0 || ::connect(file, address.ai_addr, address.ai_addrlen) != 0 ? errno : 0;
  while (error == EINPROGRESS && patience > Duration::zero() && !cancelled()) {
    pollfd polled{file, POLLOUT, 0};
    socklen_t size = sizeof error;
    if (::poll(&polled, 1, poll_ms) > 0) ::getsockopt(file, SOL_SOCKET, SO_ERROR, &error, &size);
    patience -= std::chrono::milliseconds(poll_ms);
  }
  if (error == 0) return true;
  trouble = error == EINPROGRESS ? "it does not answer" : std::generic_category().message(error);
  if (file >= 0) ::close(std::exchange(file, -1));
  return false;
}

void Attempt::run(const std::function<bool()>& cancelled, Duration patience) {
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  const int error = ::getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found);
  if (error != 0) {
    trouble = ::gai_strerror(error);
    return;
  }
  for (const addrinfo* each = found; each != nullptr; each = each->ai_next) {
    if (connect_to(*each, cancelled, patience)) break;
  }
  ::freeaddrinfo(found);
}

}  // namespace

Task<Result<void>> TcpWire::open(Time deadline) {
  close();
  const auto attempt = std::make_shared<Attempt>(host_, port_);
  const Duration patience = deadline - executor_.now();
  std::function<void(const std::function<bool()>&)> work = [attempt, patience](const std::function<bool()>& cancelled) {
    attempt->run(cancelled, patience);
  };
  co_await executor_.offload(std::move(work), Duration::zero());
  if (attempt->file < 0) {
    const std::string sentence = fmt::format("{} port {} is not reached: {}", host_, port_, attempt->trouble);
    co_return fail("disconnected", sentence);
  }
  const int file = std::exchange(attempt->file, -1);
  // Commands are a few bytes each and wait for nothing.
  const int on = 1;
  ::setsockopt(file, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  adopt(file);
  co_return Result<void>();
}

}  // namespace pizarra::line
