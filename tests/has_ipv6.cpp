#include "tests/has_ipv6.hpp"

#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace pizarra {

bool has_ipv6() {
  const int file = socket(AF_INET6, SOCK_DGRAM, 0);
  sockaddr_in6 own{};
  own.sin6_family = AF_INET6;
  own.sin6_addr = in6addr_loopback;
  const bool bound = file >= 0 && bind(file, reinterpret_cast<const sockaddr*>(&own), sizeof own) == 0;
  close(file);
  return bound;
}

}  // namespace pizarra
