#include "tests/free_port.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <stdexcept>
#include <sys/socket.h>
#include <unistd.h>

namespace pizarra {

namespace {

constexpr int lowest = 10'000;
constexpr int count = 20'000;

bool at(int port, bool (*works)(int file, const sockaddr* name, socklen_t size)) {
  sockaddr_in name{};
  name.sin_family = AF_INET;
  name.sin_port = htons(static_cast<std::uint16_t>(port));
  name.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const int file = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  const bool worked = works(file, reinterpret_cast<const sockaddr*>(&name), sizeof name);
  close(file);
  return worked;
}

bool can_listen(int port) {
  return at(port, [](int file, const sockaddr* name, socklen_t size) {
    const int yes = 1;
    setsockopt(file, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    return bind(file, name, size) == 0 && listen(file, 1) == 0;
  });
}

// Tests that run at once have neighbouring process numbers, and take a few ports each.
int next_port() {
  constexpr int of_a_process = 20;
  static int taken = 0;
  const int process = getpid() % (count / of_a_process);
  return lowest + (process * of_a_process + taken++) % count;
}

}  // namespace

bool can_connect(int port) {
  return at(port, [](int file, const sockaddr* name, socklen_t size) { return connect(file, name, size) == 0; });
}

int free_port() {
  for (int tries = 0; tries < count; ++tries) {
    const int port = next_port();
    if (can_listen(port)) return port;
  }
  throw std::runtime_error("no port is free");
}

int two_free_ports() {
  int port = free_port();
  for (int next = free_port(); next != port + 1; next = free_port()) port = next;
  return port;
}

}  // namespace pizarra
