#include "blackboard/streams/listen_address.hpp"

#include <arpa/inet.h>
#include <array>
#include <netdb.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include "blackboard/streams/file.hpp"
#include "blackboard/wire/wire_address.hpp"

namespace pizarra::streams {

namespace {

constexpr std::string_view tcp = "tcp://";
// Set aside for examples (RFC 5737): nobody has it, and the way there is the way out.
constexpr const char* somewhere = "192.0.2.1";

std::string host_of(const std::string& address) {
  const std::string host = address.substr(tcp.size(), address.rfind(':') - tcp.size());
  return host == "*" || host == "0.0.0.0" ? somewhere : host;
}

// A datagram socket that is connected sends nothing, but knows its own end of the way. IPv4, as ZeroMQ is used here.
sockaddr_in own_end(const addrinfo& there) {
  sockaddr_in own{};
  socklen_t size = sizeof own;
  const File way(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0));
  const bool known = way && connect(way.number(), there.ai_addr, there.ai_addrlen) == 0 &&
                     getsockname(way.number(), reinterpret_cast<sockaddr*>(&own), &size) == 0;
  return known ? own : sockaddr_in{};
}

}  // namespace

std::string stream_listen_address(const std::string& board_address) {
  if (!wire::check_address(board_address) || wire::is_ipc(board_address)) return {};
  addrinfo hints{};
  hints.ai_family = AF_INET;
  hints.ai_socktype = SOCK_DGRAM;
  addrinfo* there = nullptr;
  // Any port will do: 9 is for discarding.
  if (getaddrinfo(host_of(board_address).c_str(), "9", &hints, &there) != 0) return {};
  const sockaddr_in own = own_end(*there);
  freeaddrinfo(there);
  constexpr std::uint32_t loopback_net = 127;
  const std::uint32_t address = ntohl(own.sin_addr.s_addr);
  if (address == 0 || address >> 24 == loopback_net) return {};
  std::array<char, INET_ADDRSTRLEN> text{};
  inet_ntop(AF_INET, &own.sin_addr, text.data(), text.size());
  return std::string(tcp) + text.data() + ":*";
}

}  // namespace pizarra::streams
