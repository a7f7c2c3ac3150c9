#include "drivers/line/tcp_port.hpp"

#include <arpa/inet.h>
#include <cerrno>
#include <fmt/format.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

namespace pizarra::line {

namespace {

constexpr int most_waiting = 4;

std::unexpected<Failure> refused(const std::string& address, std::uint16_t port, const std::string& why) {
  return fail("bad-address", fmt::format("cannot listen at {} port {}: {}", address, port, why));
}

// A client that comes while nobody looks waits in the listener's queue.
int accept_one(int listener) { return ::accept4(listener, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC); }

}  // namespace

Result<Listening> listen_at(const std::string& address, std::uint16_t port, int type) {
  sockaddr_in at{};
  at.sin_family = AF_INET;
  at.sin_port = htons(port);
  if (::inet_pton(AF_INET, address.c_str(), &at.sin_addr) != 1) return refused(address, port, "no such address");
  const bool connects = type == SOCK_STREAM;
  const int listener = ::socket(AF_INET, type | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  const int on = 1;
  socklen_t size = sizeof at;
  if (connects) ::setsockopt(listener, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  auto* generic = reinterpret_cast<sockaddr*>(&at);
  if (::bind(listener, generic, size) != 0 || (connects && ::listen(listener, most_waiting) != 0) ||
      ::getsockname(listener, generic, &size) != 0) {
    const std::string why = system_error();
    ::close(listener);
    return refused(address, port, why);
  }
  return Listening{listener, ntohs(at.sin_port)};
}

Result<std::unique_ptr<TcpPort>> TcpPort::listen(Executor& executor, const std::string& address, std::uint16_t port) {
  const Result<Listening> listening = listen_at(address, port);
  if (!listening) return fail(listening);
  return std::unique_ptr<TcpPort>(new TcpPort(executor, listening->file, listening->port));
}

TcpPort::TcpPort(Executor& executor, int listener, std::uint16_t port)
    : FileWire(executor), listener_(listener), port_(port) {}

TcpPort::~TcpPort() { ::close(listener_); }

Task<Result<void>> TcpPort::open(Time deadline) {
  close();
  struct Watched {
    Watched(Executor& the_executor, int the_file) : executor(the_executor), file(the_file), come(the_executor) {
      executor.watch_readable(file, [this] { come.set(); });
    }
    Watched(const Watched&) = delete;
    Watched& operator=(const Watched&) = delete;
    ~Watched() { executor.unwatch_readable(file); }
    Executor& executor;
    int file;
    Event come;
  };
  int client = accept_one(listener_);
  Watched watched(executor_, listener_);
  while (client < 0) {
    const bool come = co_await watched.come.wait(deadline);
    if (!come) co_return fail("timeout", "nobody connected in time");
    watched.come.reset();
    client = accept_one(listener_);
  }
  const int on = 1;
  ::setsockopt(client, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  adopt(client);
  co_return Result<void>();
}

}  // namespace pizarra::line
