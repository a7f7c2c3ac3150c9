#include "tests/network/connection.hpp"

#include <arpa/inet.h>
#include <cerrno>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace pizarra::network {

namespace {

constexpr int patience_ms = 150;

}  // namespace

std::optional<int> connect_to(const std::string& address, int port) {
  sockaddr_in name{};
  name.sin_family = AF_INET;
  name.sin_port = htons(static_cast<std::uint16_t>(port));
  inet_pton(AF_INET, address.c_str(), &name.sin_addr);
  const int file = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  const bool begun = connect(file, reinterpret_cast<const sockaddr*>(&name), sizeof name) == 0 || errno == EINPROGRESS;
  pollfd connecting{file, POLLOUT, 0};
  if (begun && poll(&connecting, 1, patience_ms) == 1 && (connecting.revents & (POLLERR | POLLHUP)) == 0) return file;
  close(file);
  return std::nullopt;
}

bool listens(const std::string& address, int port) {
  const std::optional<int> file = connect_to(address, port);
  if (file) close(*file);
  return file.has_value();
}

}  // namespace pizarra::network
